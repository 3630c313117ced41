#include "calibration/model_fit.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "bondstatic/error.hpp"
#include "calibration/scaling.hpp"

namespace bondstatic {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Such parameters have no answer, others may.
bool shorter_step_may_cure(ExitCode code) {
  return code == ExitCode::invalid_input || code == ExitCode::mechanism || code == ExitCode::not_accurate;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

ModelFit::ModelFit(const std::vector<CalibrationTest>& tests, std::vector<CalibrationParameter> parameters,
                   std::vector<TargetRow> rows, const std::vector<CalibrationTarget>& targets,
                   const CalibrationOptions& options)
    : parameters_(std::move(parameters)),
      rows_(std::move(rows)),
      targets_(targets),
      options_(options),
      evaluation_(tests, rows_) {}

Minimum ModelFit::minimum() {
  const Index count = Index(parameters_.size());
  LeastSquares problem{.start = VectorXd(count),
                       .lower = VectorXd(count),
                       .upper = VectorXd(count),
                       .residuals = [this](const VectorXd& x) { return residuals(x); },
                       .jacobian = [this] { return jacobian(); },
                       .loss = options_.loss,
                       .most_evaluations = options_.most_evaluations,
                       .tolerance = options_.tolerance};
  for (Index p = 0; p < count; ++p) {
    const CalibrationParameter& parameter = parameters_[std::size_t(p)];
    problem.start[p] = scaled(parameter, parameter.start);
    problem.lower[p] = scaled(parameter, parameter.lower);
    problem.upper[p] = scaled(parameter, parameter.upper);
  }
  return minimise(problem);
}

std::optional<VectorXd> ModelFit::residuals(const VectorXd& x) {
  const auto begin = Clock::now();
  const std::vector<double> values = unscaled(parameters_, x);
  const std::optional<VectorXd> found = attempt(values);
  history_.push_back({.parameters = values,
                      .cost = found ? cost(options_.loss, *found) : not_given,
                      .seconds = seconds_since(begin),
                      .accepted = false});
  if (options_.progress) options_.progress(int(history_.size()), history_.back().cost);
  return found;
}

std::optional<VectorXd> ModelFit::attempt(const std::vector<double>& values) {
  try {
    return solved(values);
  } catch (const Error& error) {
    if (history_.empty() || !shorter_step_may_cure(error.code())) throw;
    failure_ = first_line(error.what());
    return {};
  }
}

VectorXd ModelFit::solved(const std::vector<double>& values) {
  outputs_ = evaluation_.outputs(values);
  VectorXd found = outputs_;
  for (Index i = 0; i < found.size(); ++i) {
    const TargetRow& row = rows_[std::size_t(i)];
    const CalibrationTarget& target = targets_[row.target];
    if (!std::isfinite(found[i]))
      throw Error(ExitCode::invalid_input,
                  fmt::format("output {} has no value\n    cure: leave that target out, or ask for an output "
                              "that the model has",
                              target.output));
    found[i] = (found[i] - target.wanted) / row.size;
  }
  return found;
}

MatrixXd ModelFit::jacobian() {
  const auto begin = Clock::now();
  CalibrationStep& step = history_.back();
  best_outputs_ = outputs_;  // derivatives are asked of the best point alone
  MatrixXd found = evaluation_.derivatives();
  for (std::size_t i = 0; i < rows_.size(); ++i) found.row(Index(i)) /= rows_[i].size;
  for (std::size_t p = 0; p < parameters_.size(); ++p)
    found.col(Index(p)) *= slope(parameters_[p], step.parameters[p]);
  if (start_jacobian_.size() == 0) start_jacobian_ = found;
  step.accepted = true;
  step.seconds += seconds_since(begin);
  return found;
}

}  // namespace bondstatic
