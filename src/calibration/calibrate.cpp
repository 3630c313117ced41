// Calibration told as numbered steps: what is asked is checked, least squares are solved, and what is known
// of the answer is said.
#include <algorithm>
#include <cmath>

#include "bondstatic/calibration.hpp"
#include "calibration/certainty.hpp"
#include "calibration/check_input.hpp"
#include "calibration/model_fit.hpp"
#include "calibration/reason.hpp"
#include "calibration/scaling.hpp"

namespace bondstatic {

namespace {

std::vector<AchievedTarget> achieved(const std::vector<CalibrationTest>& tests,
                                     const std::vector<TargetRow>& rows,
                                     const std::vector<CalibrationTarget>& targets,
                                     const Eigen::VectorXd& outputs, const Eigen::VectorXd& residuals) {
  std::vector<AchievedTarget> list;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CalibrationTarget& target = targets[rows[i].target];
    list.push_back({.output = target.output,
                    .test = tests.size() > 1 ? tests[rows[i].test].name : target.test,
                    .wanted = target.wanted,
                    .achieved = outputs[Eigen::Index(i)],
                    .residual = residuals[Eigen::Index(i)]});
  }
  return list;
}

}  // namespace

CalibrationResult calibrate(const std::vector<CalibrationTest>& tests,
                            const std::vector<CalibrationParameter>& asked,
                            const std::vector<CalibrationTarget>& targets,
                            const CalibrationOptions& options) {
  // 1. Check what is asked.
  const std::vector<CalibrationParameter> parameters = with_starts(tests, asked);
  check_calibration(tests, parameters, targets, options);
  const std::vector<TargetRow> rows = target_rows(tests, targets);
  const bool with_tolerances = !std::isnan(targets.front().tolerance);

  // 2. Minimise.
  ModelFit fit(tests, parameters, rows, targets, options);
  const Minimum minimum = fit.minimum();

  // 3. Say what was found.
  CalibrationResult result;
  result.history = fit.history();
  result.solves = fit.evaluation().solves();
  result.warnings = fit.evaluation().warnings();
  result.targets = achieved(tests, rows, targets, fit.best_outputs(), minimum.residuals);
  const std::vector<double> values = unscaled(parameters, minimum.x);
  for (std::size_t p = 0; p < parameters.size(); ++p)
    result.parameters.push_back(
        {.name = parameters[p].name, .value = values[p], .at_bound = minimum.held[p]});
  result.converged = minimum.ending == Ending::minimum;
  result.reached = std::all_of(result.targets.begin(), result.targets.end(),
                               [&](const AchievedTarget& t) { return met(t, with_tolerances); });
  result.reason = reason(result, minimum.ending, parameters, with_tolerances, fit.failure());

  // 4. And how certain it is.
  tell_certainty(result, fit.start_jacobian(), minimum, parameters, options.loss, with_tolerances);
  return result;
}

}  // namespace bondstatic
