#include "app/run_case.hpp"

#include <algorithm>

#include "bondstatic/sensitivity.hpp"
#include "results/sensitivities.hpp"
#include "solver/machine.hpp"
#include "statics/stopwatch.hpp"

namespace bondstatic {

Case read_case(const SolveArguments& arguments, const std::vector<std::string>& overrides, Purpose purpose) {
  const int threads = arguments.threads > 0 ? arguments.threads : cores_at_hand();
  Case given = read_case(arguments.file, overrides, arguments.folder, purpose, threads);
  if (!arguments.solver.empty()) given.solve.solver = arguments.solver;
  given.solve.backend_options = arguments.backend_options;
  if (arguments.threads > 0) given.solve.threads = arguments.threads;
  return given;
}

Answer answer(const Case& given, const std::function<void(const std::string&)>& progress,
              Sensitivities sensitivities) {
  StaticOptions options = given.solve;
  options.progress = progress;
  if (sensitivities == Sensitivities::none) {
    Answer result{solve_statics(given.model, options), {}};
    result.outputs = evaluate_outputs(given.model, result.solution, given.outputs);
    return result;
  }
  if (given.outputs.empty())
    throw Error(ExitCode::invalid_input,
                given.file +
                    ": no outputs to differentiate\n    cure: add [[outputs]], the numbers that you ask for");
  StaticAnalysis analysis(given.model, options);
  Answer result{analysis.solve(), {}};
  StaticReport& report = result.solution.report;
  result.outputs = evaluate_outputs(given.model, result.solution, given.outputs);
  Stopwatch timed(report.phases, options.progress);
  const auto warnings = timed("sensitivities", [&] {
    return add_sensitivities(result.outputs, given.outputs, given.model, result.solution, analysis,
                             sensitivities == Sensitivities::by_bond, report.threads);
  });
  report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  return result;
}

}  // namespace bondstatic
