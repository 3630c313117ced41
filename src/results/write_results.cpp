#include <algorithm>

#include "bondstatic/results.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "results/result_set.hpp"
#include "results/sensitivities.hpp"

namespace bondstatic {

std::vector<std::string> result_files(const ModelFacts& model, int ranks) {
  std::vector<std::string> names;
  for (const std::string& load_case : model.load_cases)
    for (const std::string& name : state_files(model.load_cases, load_case, ranks)) names.push_back(name);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

void check_result_folder(const ModelFacts& model, const std::string& folder, int ranks) {
  sweep_stale_staging(folder);
  check_writable(folder, result_files(model, ranks), earlier_files(folder));
}

std::vector<std::string> result_files(const Model& model, const std::vector<OutputValue>& outputs) {
  std::vector<std::string> names = result_files(facts_of(model));
  const std::vector<std::string> more = sensitivity_files(outputs);
  names.insert(names.end() - 1, more.begin(), more.end());
  return names;
}

void check_result_folder(const Model& model, const std::string& folder) {
  check_result_folder(facts_of(model), folder);
}

void write_results(const Model& model, const RunInfo& run, const StaticSolution& solution,
                   const std::vector<OutputValue>& outputs, const std::string& folder,
                   const std::function<void()>& checkpoint, const std::function<void(double)>& progress) {
  const auto particles = Index(model.particles.size()), bonds = Index(model.bonds.size());
  const double bytes = 1 + double(model.load_cases.size()) *
                               (typical_table_bytes(particles, bonds) + typical_grid_bytes(particles, bonds));
  const FileSet* written = nullptr;
  const Checkpoint look = [&] {
    if (checkpoint) checkpoint();
    if (progress && written) progress(std::min(1.0, written->bytes() / bytes));
  };
  FileSet files(folder, look, solution.report.threads);
  written = &files;
  files.supersede(earlier_files(folder));
  for (const State& state : solution.cases) write_state(files, model, state);
  write_sensitivities(files, model, outputs);
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json")
      .append(summary_json(model, run, solution, outputs, result_files(model, outputs)));
  files.commit();
}

}  // namespace bondstatic
