#include <algorithm>

#include "bondstatic/results.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

/// Bytes of the tables and the grid of a load case where no number is zero: some 18 characters a number in a
/// table, and 32 for three in base64.
double typical_state_bytes(const Model& model) {
  constexpr double in_table = 18, in_grid = 32 / 3.0;
  const double particles = double(model.particles.size()), bonds = double(model.bonds.size());
  return 1 + particles * 17 * (in_table + in_grid) + bonds * (15 * in_table + 19 * in_grid);
}

}  // namespace

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
                   const std::function<void()>& checkpoint, const std::function<void(double)>& progress) {
  const double bytes = double(model.load_cases.size()) * typical_state_bytes(model);
  const FileSet* written = nullptr;
  const Checkpoint look = [&] {
    if (checkpoint) checkpoint();
    if (progress && written) progress(std::min(1.0, written->bytes() / bytes));
  };
  FileSet files(folder, look, solution.report.threads);
  written = &files;
  files.supersede(earlier_files(folder));
  for (const State& state : solution.cases) write_state(files, model, state);
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json").append(summary_json(model, run, solution, outputs, result_files(model)));
  files.commit();
}

}  // namespace bondstatic
