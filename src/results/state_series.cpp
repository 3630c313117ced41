#include "results/state_series.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "io/csv_writer.hpp"
#include "io/replace_file.hpp"
#include "io/stale_staging.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".vtu";

/// VTK's collection of the states.
std::string series_text(const StateSeries& series) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (const SeriesState& state : series.states)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", csv_number(state.time),
                        state_file(series.kind, state.number));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace

std::string state_file(const std::string& kind, Index number) {
  return fmt::format("{}_{:04}{}", kind, number, ending);
}

std::string series_file(const std::string& kind) {
  return kind + ".pvd";
}

std::string unfinished_folder(const std::string& kind) {
  return kind + ".unfinished";
}

bool is_state_file(const std::string& kind, const std::string& name) {
  const std::string file = fs::path(name).filename().string(), begins = kind + "_";
  if (!file.starts_with(begins) || !file.ends_with(ending)) return false;
  const std::string number =
      file.substr(begins.size(), file.size() - begins.size() - std::string(ending).size());
  return number.size() >= 4 && number.find_first_not_of("0123456789") == std::string::npos;
}

void add_state(const StateSeries& series, Index number, const std::function<void(OutputFile&)>& write) {
  const std::string name = state_file(series.kind, number);
  FileSet files(series.unfinished);
  files.supersede({name});
  write(files.create(name));
  files.commit();
  replace_file(series.unfinished / series_file(series.kind), series_text(series));
}

std::vector<std::string> series_files(const StateSeries& series) {
  std::vector<std::string> names;
  for (const SeriesState& state : series.states)
    names.push_back(series.prefix + state_file(series.kind, state.number));
  if (!names.empty()) names.push_back(series.prefix + series_file(series.kind));
  return names;
}

std::vector<std::string> states_in(const fs::path& folder, const StateSeries& series) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / series.prefix, ignored))
    if (const std::string name = entry.path().filename().string(); is_state_file(series.kind, name))
      names.push_back(series.prefix + name);
  return names;
}

void adopt_states(FileSet& files, const StateSeries& series) {
  for (const SeriesState& state : series.states) {
    const std::string name = state_file(series.kind, state.number);
    const fs::path from = series.unfinished / name, to = files.shared_folder() / (series.prefix + name);
    std::error_code no_links, failed;
    fs::create_directories(to.parent_path(), failed);
    fs::create_hard_link(from, to, no_links);
    if (no_links) fs::copy_file(from, to, failed);
    if (failed) throw Error(ExitCode::internal, fmt::format("{}: {}", from.string(), failed.message()));
    files.adopt(series.prefix + name);
  }
  if (!series.states.empty())
    files.create(series.prefix + series_file(series.kind)).append(series_text(series));
}

void check_states(const StateSeries& series, const char* checkpoint) {
  for (const SeriesState& state : series.states) {
    const fs::path file = series.unfinished / state_file(series.kind, state.number);
    if (!fs::is_regular_file(file))
      throw Error(ExitCode::invalid_input,
                  fmt::format("{}: not there, and {} speaks of it\n    cure: put it back, or remove the "
                              "checkpoint to start anew",
                              file.string(), checkpoint));
  }
}

void remove_other_states(const StateSeries& series) {
  std::error_code ignored;
  if (!fs::is_directory(series.unfinished, ignored)) return;
  sweep_stale_staging(series.unfinished);
  std::vector<std::string> kept;
  for (const SeriesState& state : series.states) kept.push_back(state_file(series.kind, state.number));
  std::sort(kept.begin(), kept.end());
  std::vector<fs::path> gone;
  for (const auto& entry : fs::directory_iterator(series.unfinished, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_state_file(series.kind, name) && !std::binary_search(kept.begin(), kept.end(), name))
      gone.push_back(entry.path());
  }
  if (kept.empty())
    for (const std::string hidden : {"", "."})
      for (const char* ending : {"", ".new", ".part"})
        gone.push_back(series.unfinished / (hidden + series_file(series.kind) + ending));
  for (const fs::path& path : gone) fs::remove(path, ignored);
  if (kept.empty()) fs::remove(series.unfinished, ignored);
}

}  // namespace bondstatic
