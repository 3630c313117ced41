#include <fmt/format.h>

#include <filesystem>

#include "app/calibrate_report.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/status_line.hpp"
#include "bondstatic/calibration.hpp"
#include "calibration/ceres_module.hpp"
#include "io/file_set.hpp"
#include "io/nearest_name.hpp"
#include "results/result_set.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

const std::vector<std::string>& calibration_files() {
  static const std::vector<std::string> files{"history.csv", "calibrated.toml", "calibration.json"};
  return files;
}

/// What an earlier calibration left in the folder; never the case that is read itself.
std::vector<std::string> replaceable(const SolveArguments& arguments) {
  namespace fs = std::filesystem;
  std::vector<std::string> names = earlier_files(arguments.folder, "calibration.json");
  std::erase_if(names, [&](const std::string& name) {
    std::error_code not_there;
    return fs::equivalent(fs::path(arguments.folder) / name, arguments.file, not_there);
  });
  return names;
}

CalibrationProblem read_problem(const SolveArguments& arguments) {
  const int threads = arguments.threads > 0 ? arguments.threads : cores_at_hand();
  CalibrationProblem problem = read_calibration(arguments.file, arguments.overrides, threads);
  for (CalibrationTest& test : problem.tests) {
    if (!arguments.solver.empty()) test.solve.solver = arguments.solver;
    test.solve.backend_options = arguments.backend_options;
    if (arguments.threads > 0) test.solve.threads = arguments.threads;
  }
  return problem;
}

void write(const CalibrationProblem& problem, const CalibrationResult& result,
           const SolveArguments& arguments) {
  std::vector<double> values;
  for (const CalibratedParameter& parameter : result.parameters) values.push_back(parameter.value);
  const std::vector<std::string>& names = calibration_files();
  const std::string calibrated = calibrated_case(problem, arguments.overrides, arguments.folder, values);
  const DeferredInterrupts guard;
  FileSet files(arguments.folder, DeferredInterrupts::check);
  files.supersede(replaceable(arguments));
  files.create(names[0]).append(calibration_history(result));
  files.create(names[1]).append(calibrated);
  files.create(names[2]).append(calibration_json(problem, result, names));
  files.commit();
}

}  // namespace

ExitCode calibrate(const SolveArguments& arguments) {
  ceres_module();  // where it is not there, nothing is read in vain
  StatusLine status;
  status.show("read");
  CalibrationProblem problem = read_problem(arguments);
  const std::string& folder = arguments.folder;
  if (!folder.empty()) {
    sweep_stale_staging(folder);
    check_writable(folder, calibration_files(), replaceable(arguments));
  }
  status.show("calibrate: first evaluation");
  problem.options.progress = [&](int evaluation, double cost) {
    status.show(fmt::format("calibrate: {} evaluated, cost {:.3e}", evaluation, cost));
  };
  const CalibrationResult result =
      calibrate(problem.tests, problem.parameters, problem.targets, problem.options);

  if (!folder.empty()) {
    status.show("write");
    write(problem, result, arguments);
  }
  status.clear();
  const std::vector<std::string> files = folder.empty() ? std::vector<std::string>{} : calibration_files();
  fmt::print("{}", arguments.json
                       ? calibration_json(problem, result, files)
                       : calibration_report(problem, result,
                                            folder.empty() ? "" : folder + ": " + name_list(files)));
  return result.converged && result.reached ? ExitCode::done : ExitCode::not_accurate;
}

}  // namespace bondstatic
