// The tests as least squares of scaled parameters, and the record of what was asked of them.
#pragma once

#include <string>
#include <vector>

#include "calibration/evaluation.hpp"
#include "calibration/least_squares.hpp"

namespace bondstatic {

class ModelFit {
 public:
  /// `targets` and `options` last as long as this does.
  ModelFit(const std::vector<CalibrationTest>& tests, std::vector<CalibrationParameter> parameters,
           std::vector<TargetRow> rows, const std::vector<CalibrationTarget>& targets,
           const CalibrationOptions& options);

  /// Throws what solves throw at the start, what progress throws, and of later solves what no shorter step
  /// can cure (interruption, memory).
  Minimum minimum();

  /// Of each row, at the minimum.
  const Eigen::VectorXd& best_outputs() const { return best_outputs_; }
  const Eigen::MatrixXd& start_jacobian() const { return start_jacobian_; }
  const std::vector<CalibrationStep>& history() const { return history_; }
  const Evaluation& evaluation() const { return evaluation_; }

  /// What the last failed solve said; "" where none did.
  const std::string& failure() const { return failure_; }

 private:
  std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x);
  std::optional<Eigen::VectorXd> attempt(const std::vector<double>& values);
  Eigen::VectorXd solved(const std::vector<double>& values);
  Eigen::MatrixXd jacobian();

  const std::vector<CalibrationParameter> parameters_;
  const std::vector<TargetRow> rows_;
  const std::vector<CalibrationTarget>& targets_;
  const CalibrationOptions& options_;
  Evaluation evaluation_;
  std::vector<CalibrationStep> history_;
  Eigen::VectorXd outputs_, best_outputs_;
  Eigen::MatrixXd start_jacobian_;
  std::string failure_;
};

}  // namespace bondstatic
