#include "results/relaxation_series.hpp"

#include <algorithm>

#include "bondstatic/results.hpp"
#include "results/grid.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

Column velocities(const std::vector<Vector6>& velocity) {
  return {"velocity", 3 * Index(velocity.size()),
          Column::Numbers<double>([&](Index i) { return velocity[std::size_t(i / 3)][i % 3]; }), 3};
}

}  // namespace

StateSeries relaxation_series(const Model& model, const std::string& load_case,
                              const std::vector<SavedState>& saved, const std::string& folder) {
  const std::string prefix = prefix_of(model.load_cases, load_case);
  StateSeries series{relaxation_kind, fs::path(folder) / unfinished_folder(relaxation_kind), prefix};
  if (!prefix.empty()) series.unfinished /= prefix.substr(0, prefix.size() - 1);
  for (const SavedState& state : saved) series.states.push_back({state.step, state.time});
  return series;
}

void show_relaxation(const Model& model, const State& state, const std::vector<Vector6>& velocity,
                     const std::vector<SavedState>& saved, const std::string& folder) {
  add_state(relaxation_series(model, state.name, saved, folder), saved.back().step,
            [&](OutputFile& file) { write_grid(file, model, state, {velocities(velocity)}); });
}

void check_shown_relaxation(const Model& model, const std::vector<std::vector<SavedState>>& saved,
                            const std::string& folder) {
  for (std::size_t c = 0; c < saved.size(); ++c)
    check_states(relaxation_series(model, model.load_cases.at(c), saved[c], folder), checkpoint_file);
}

void keep_shown_relaxation(const Model& model, const std::vector<std::vector<SavedState>>& saved,
                           const std::string& folder) {
  const fs::path unfinished = fs::path(folder) / unfinished_folder(relaxation_kind);
  std::vector<StateSeries> known;
  for (std::size_t c = 0; c < saved.size(); ++c)
    known.push_back(relaxation_series(model, model.load_cases.at(c), saved[c], folder));
  // An earlier run may have had other load cases.
  std::vector<fs::path> folders;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(unfinished, ignored))
    if (entry.is_directory(ignored)) folders.push_back(entry.path());
  folders.push_back(unfinished);
  for (const fs::path& place : folders) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const StateSeries& series) { return series.unfinished == place; });
    remove_other_states(found == known.end() ? StateSeries{relaxation_kind, place} : *found);
  }
}

}  // namespace bondstatic
