#include "report/found_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <pugixml.hpp>

#include "bondstatic/error.hpp"
#include "io/text_file.hpp"
#include "results/result_set.hpp"
#include "results/state_series.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

constexpr const char* cure = "let the command that made it write the folder anew";

/// A name of a file or folder that lies in the folder itself.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos &&
         name.find('\0') == std::string::npos;
}

/// A file of VTK that names others.
class Listing {
 public:
  explicit Listing(const fs::path& file) : file_(file.string()) {
    std::vector<Fault> faults;
    auto text = read_text_file(file_, {}, faults);
    if (!text) throw InputError(std::move(faults));
    text_ = std::move(*text);
    const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed) refuse(parsed.offset, fmt::format("is no XML: {}", parsed.description()));
  }

  std::vector<pugi::xml_node> elements(const char* kind, const char* name) const {
    const auto of = document_.child("VTKFile").child(kind).children(name);
    std::vector<pugi::xml_node> all(of.begin(), of.end());
    if (all.empty()) refuse(0, fmt::format("lists no <{}> in <VTKFile> <{}>", name, kind));
    return all;
  }

  std::string attribute(const pugi::xml_node& element, const char* name) const {
    const pugi::xml_attribute found = element.attribute(name);
    if (!found) refuse(element.offset_debug(), fmt::format("has no {}=\"..\"", name));
    return found.value();
  }

  /// The path of a file beside this one; nothing where it is not there.
  std::optional<std::string> neighbour(const pugi::xml_node& element, const std::string& name) const {
    if (!is_plain_name(name))
      refuse(element.offset_debug(),
             fmt::format("\"{}\" must be the name of a file in the same folder", name));
    const fs::path file = fs::path(file_).parent_path() / name;
    std::error_code ignored;
    return fs::is_regular_file(file, ignored) ? std::optional(file.string()) : std::nullopt;
  }

  [[noreturn]] void refuse(std::ptrdiff_t offset, const std::string& found) const {
    const std::string before = text_.substr(0, std::size_t(std::max<std::ptrdiff_t>(offset, 0)));
    const auto line = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_end = before.rfind('\n');
    const std::size_t column = line_end == std::string::npos ? before.size() : before.size() - line_end - 1;
    throw InputError({{{file_, int(line) + 1, int(column) + 1}, found, cure}});
  }

 private:
  std::string file_, text_;
  pugi::xml_document document_;
};

}  // namespace

std::string folder_of(const std::string& folder, const JsonValue& load_case) {
  const JsonValue name = load_case["folder"];
  const std::string below = name.text_or();
  if (below.empty()) return folder;
  if (!is_plain_name(below)) name.refuse("the name of a folder in the same folder");
  return (fs::path(folder) / below).string();
}

std::vector<std::string> grid_files(const std::string& folder, PageRun& run) {
  const fs::path grid = fs::path(folder) / grid_file, pieces = fs::path(folder) / grid_of_pieces_file;
  std::error_code ignored;
  if (fs::is_regular_file(grid, ignored)) return {grid.string()};
  if (!fs::is_regular_file(pieces, ignored)) {
    run.notes.push_back(grid.string() + " is not there: nothing to be seen in three dimensions.");
    return {};
  }
  const Listing listing(pieces);
  std::vector<std::string> files;
  for (const pugi::xml_node& piece : listing.elements("PUnstructuredGrid", "Piece")) {
    const std::string name = listing.attribute(piece, "Source");
    const auto file = listing.neighbour(piece, name);
    if (!file) {
      run.notes.push_back(
          fmt::format("{} is not there, and {} names it: nothing to be seen in three dimensions.",
                      (fs::path(folder) / name).string(), grid_of_pieces_file));
      return {};
    }
    files.push_back(*file);
  }
  return files;
}

std::vector<SceneState> load_case_states(const std::string& folder, const JsonValue& summary, PageRun& run) {
  std::vector<SceneState> states;
  for (const JsonValue& one : summary["load_cases"].items()) {
    std::vector<std::string> files = grid_files(folder_of(folder, one), run);
    if (!files.empty()) states.push_back({std::move(files), one["name"].text_or(), "", std::nullopt});
  }
  return states;
}

std::vector<ShownState> shown_states(const std::string& folder, const std::string& kind, PageRun& run) {
  const fs::path series = fs::path(folder) / series_file(kind);
  std::error_code ignored;
  if (!fs::is_regular_file(series, ignored)) {
    run.notes.push_back(series.string() + " is not there: only the last state is shown.");
    return {};
  }
  std::vector<ShownState> states;
  const Listing listing(series);
  for (const pugi::xml_node& state : listing.elements("Collection", "DataSet")) {
    const std::string step = listing.attribute(state, "timestep"), name = listing.attribute(state, "file");
    double time = 0;
    const auto read = std::from_chars(step.data(), step.data() + step.size(), time);
    if (read.ec != std::errc() || read.ptr != step.data() + step.size() || !(time >= 0) || std::isinf(time))
      listing.refuse(state.offset_debug(),
                     fmt::format("timestep = \"{}\" must be a number of at least 0", step));
    if (const auto file = listing.neighbour(state, name))
      states.push_back({*file, time});
    else
      run.notes.push_back(fmt::format("{} is not there, and {} names it.", (fs::path(folder) / name).string(),
                                      series_file(kind)));
  }
  std::sort(states.begin(), states.end(),
            [](const ShownState& a, const ShownState& b) { return a.time < b.time; });
  return states;
}

}  // namespace bondstatic
