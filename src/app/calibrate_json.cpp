#include <cmath>

#include "app/calibrate_report.hpp"
#include "io/csv_writer.hpp"
#include "results/summary_parts.hpp"

namespace bondstatic {

namespace {

/// JSON has neither infinity nor NaN.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json parameters_of(const CalibrationProblem& problem, const CalibrationResult& result) {
  Json all = Json::array();
  for (std::size_t p = 0; p < result.parameters.size(); ++p) {
    const CalibratedParameter& found = result.parameters[p];
    const CalibrationParameter& asked = problem.parameters[p];
    all.push_back({{"name", found.name},
                   {"value", number(found.value)},
                   {"lower_95", number(found.lower_95)},
                   {"upper_95", number(found.upper_95)},
                   {"at_bound", found.at_bound},
                   {"start", number(asked.start)},
                   {"min", number(asked.lower)},
                   {"max", number(asked.upper)},
                   {"scale", asked.logarithmic ? "log" : "linear"}});
  }
  return all;
}

Json targets_of(const CalibrationProblem& problem, const CalibrationResult& result) {
  Json all = Json::array();
  for (std::size_t t = 0; t < result.targets.size(); ++t) {
    const AchievedTarget& target = result.targets[t];
    all.push_back({{"output", target.output},
                   {"test", target.test},
                   {"wanted", number(target.wanted)},
                   {"achieved", number(target.achieved)},
                   {"residual", number(target.residual)},
                   {"tolerance", number(problem.targets[t].tolerance)},
                   {"weight", number(problem.targets[t].weight)}});
  }
  return all;
}

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < matrix.cols(); ++j) row.push_back(number(matrix(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json unidentified_of(const CalibrationResult& result) {
  Json all = Json::array();
  for (const Unidentified& one : result.unidentified) {
    Json direction = Json::object();
    for (std::size_t p = 0; p < one.direction.size(); ++p)
      direction[result.parameters[p].name] = number(one.direction[p]);
    all.push_back({{"sentence", one.sentence}, {"direction", std::move(direction)}});
  }
  return all;
}

Json history_of(const CalibrationResult& result) {
  Json all = Json::array();
  for (const CalibrationStep& step : result.history) {
    Json values = Json::object();
    for (std::size_t p = 0; p < step.parameters.size(); ++p)
      values[result.parameters[p].name] = number(step.parameters[p]);
    all.push_back({{"parameters", std::move(values)},
                   {"cost", number(step.cost)},
                   {"seconds", number(step.seconds)},
                   {"accepted", step.accepted}});
  }
  return all;
}

}  // namespace

std::string calibration_json(const CalibrationProblem& problem, const CalibrationResult& result,
                             const std::vector<std::string>& files) {
  Json singular = Json::array(), scatter = Json::array(), tests = Json::array();
  for (const double value : result.singular_values) singular.push_back(number(value));
  for (const OutputScatter& of : scatter_of(result))
    scatter.push_back({{"output", of.output},
                       {"tests", of.tests},
                       {"mean", number(of.mean)},
                       {"standard_deviation", number(of.deviation)}});
  for (const CalibrationTest& test : problem.tests)
    tests.push_back({{"name", test.name}, {"model", counts_of(facts_of(test.model))}});
  const EvaluationTimes times = times_of(result);
  std::vector<std::string> warnings = problem.warnings;
  warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
  return to_text({{"title", problem.given.title},
                  {"case", problem.given.file},
                  {"bondstatic", version()},
                  {"si_units", problem.given.si},
                  {"converged", result.converged},
                  {"reached", result.reached},
                  {"reason", result.reason},
                  {"parameters", parameters_of(problem, result)},
                  {"targets", targets_of(problem, result)},
                  {"scatter", std::move(scatter)},
                  {"correlation", rows_of(result.correlation)},
                  {"singular_values", std::move(singular)},
                  {"unidentified", unidentified_of(result)},
                  {"tests", std::move(tests)},
                  {"solves", result.solves},
                  {"seconds", {{"first", times.first}, {"later", number(times.later)}}},
                  {"history", history_of(result)},
                  {"warnings", warnings},
                  {"files", files}});
}

std::string calibration_history(const CalibrationResult& result) {
  std::string text = "evaluation,cost,seconds,accepted";
  for (const CalibratedParameter& parameter : result.parameters) text += "," + csv_field(parameter.name);
  text += "\n";
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    const CalibrationStep& step = result.history[i];
    text += std::to_string(i + 1) + "," + csv_number(step.cost) + "," + csv_number(step.seconds) + "," +
            (step.accepted ? "1" : "0");
    for (const double value : step.parameters) text += "," + csv_number(value);
    text += "\n";
  }
  return text;
}

}  // namespace bondstatic
