#include "bondstatic/results.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

std::vector<std::string> result_files(const Model& model) {
  std::vector<std::string> names;
  for (const std::string& load_case : model.load_cases)
    for (const std::string& name : state_files(model, load_case)) names.push_back(name);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

void check_result_folder(const Model& model, const std::string& folder) {
  sweep_stale_staging(folder);
  check_writable(folder, result_files(model), earlier_files(folder));
}

void write_results(const Model& model, const RunInfo& run, const StaticSolution& solution,
                   const std::vector<OutputValue>& outputs, const std::string& folder,
                   const std::function<void()>& checkpoint) {
  FileSet files(folder, checkpoint);
  files.supersede(earlier_files(folder));
  for (const State& state : solution.cases) write_state(files, model, state);
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json").append(summary_json(model, run, solution, outputs, result_files(model)));
  files.commit();
}

}  // namespace bondstatic
