#include "results/fracture_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bondstatic/error.hpp"
#include "io/replace_file.hpp"
#include "results/bond_utilisation.hpp"
#include "results/grid.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view begins = "fracture_", ends = ".vtu";

}  // namespace

std::string fracture_state_file(Index events) {
  return fmt::format("{}{:04}{}", begins, events, ends);
}

bool is_fracture_state(const std::string& name) {
  if (!name.starts_with(begins) || !name.ends_with(ends)) return false;
  const std::size_t digits = name.size() - begins.size() - ends.size();
  const std::string number = name.substr(begins.size(), digits);
  return digits >= 4 && number.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<Column> fracture_columns(const Model& model, const State& state,
                                     const std::vector<Index>& break_event) {
  std::vector<Index> steps;
  steps.reserve(break_event.size());
  for (const Index event : break_event) steps.push_back(event + 1);
  return {{"break_step", std::move(steps)}, {"utilisation", bond_utilisations(model, state, break_event)}};
}

std::string series_text(const std::vector<Index>& states) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (const Index events : states)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", events,
                        fracture_state_file(events));
  return text + "</Collection>\n</VTKFile>\n";
}

void show_fracture(const Model& model, const State& state, const std::vector<Index>& break_event,
                   FractureRecord& record, const std::string& folder) {
  const Index events = 1 + *std::max_element(break_event.begin(), break_event.end());
  const fs::path unfinished = fs::path(folder) / unfinished_folder;
  FileSet files(unfinished);
  files.supersede({fracture_state_file(events)});
  write_grid(files.create(fracture_state_file(events)), model, state, {},
             fracture_columns(model, state, break_event));
  files.commit();
  auto& states = record.states;
  const auto place = std::lower_bound(states.begin(), states.end(), events);
  if (place == states.end() || *place != events) states.insert(place, events);
  replace_file(unfinished / series_file, series_text(states));
}

void adopt_states(FileSet& files, const std::vector<Index>& states, const std::string& folder) {
  for (const Index events : states) {
    const std::string name = fracture_state_file(events);
    const fs::path from = fs::path(folder) / unfinished_folder / name, to = files.shared_folder() / name;
    std::error_code no_links;
    fs::create_hard_link(from, to, no_links);
    std::error_code failed;
    if (no_links) fs::copy_file(from, to, failed);
    if (failed) throw Error(ExitCode::internal, fmt::format("{}: {}", from.string(), failed.message()));
    files.adopt(name);
  }
}

void check_states(const std::vector<Index>& states, const std::string& folder) {
  for (const Index events : states) {
    const fs::path file = fs::path(folder) / unfinished_folder / fracture_state_file(events);
    if (!fs::is_regular_file(file))
      throw Error(ExitCode::invalid_input,
                  fmt::format("{}: not there, and {} speaks of it\n    cure: put it back, or remove the "
                              "checkpoint to start anew",
                              file.string(), fracture_checkpoint_file));
  }
}

void remove_states(const std::string& folder, const std::vector<Index>& but) {
  const fs::path unfinished = fs::path(folder) / unfinished_folder;
  std::error_code ignored;
  std::vector<fs::path> gone;
  for (const auto& entry : fs::directory_iterator(unfinished, ignored)) {
    const std::string name = entry.path().filename().string();
    const auto kept = [&](Index events) { return fracture_state_file(events) == name; };
    if (is_fracture_state(name) && std::none_of(but.begin(), but.end(), kept)) gone.push_back(entry.path());
  }
  if (but.empty())
    for (const std::string hidden : {"", "."})
      for (const char* ending : {"", ".new", ".part"})
        gone.push_back(unfinished / (hidden + series_file + ending));
  for (const fs::path& path : gone) fs::remove(path, ignored);
  if (but.empty()) fs::remove(unfinished, ignored);
}

}  // namespace bondstatic
