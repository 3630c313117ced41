// The points that Ceres asks for: residuals and Jacobian of one point are one evaluation, and the best point
// stays known, so that another Solve() may begin there at no cost.
#pragma once

#include <ceres/ceres.h>

#include <exception>
#include <optional>

#include "calibration/least_squares.hpp"

namespace bondstatic {

class Evaluations : public ceres::EvaluationCallback {
 public:
  /// Evaluates the start. Throws what the functions throw.
  explicit Evaluations(const LeastSquares& problem);

  /// Where the cost functions ask next; Ceres moves it.
  Eigen::VectorXd x;

  /// Of Ceres. Exceptions must not pass through it: they are kept for rethrow(), and all that is asked after
  /// fails.
  void PrepareForEvaluation(bool evaluate_jacobians, bool new_point) override;

  /// Of the point that was prepared; null where it has no answer.
  const Eigen::VectorXd* residuals() const;
  /// Of the best point, which is the only one that Ceres asks it of.
  const Eigen::MatrixXd& jacobian() const { return best.jacobian; }

  bool used_up() const { return count_ >= problem_.most_evaluations; }
  bool gave_up() const { return bool(failure_); }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  struct Point {
    Eigen::VectorXd x, residuals;
    Eigen::MatrixXd jacobian;
  };
  Point best;

 private:
  void evaluate(bool with_jacobian);

  const LeastSquares& problem_;
  int count_ = 0;
  std::optional<Point> trial_;  // the last point that was evaluated and is not the best; without Jacobian
  bool at_best_ = true;
  std::exception_ptr failure_;
};

}  // namespace bondstatic
