// Least squares of plain functions, for tests that need no model.
#pragma once

#include <functional>

#include "calibration/least_squares.hpp"

namespace bondstatic::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct PlainFunction {
  std::function<VectorXd(const VectorXd&)> residuals;
  std::function<MatrixXd(const VectorXd&)> jacobian;
};

/// Counts what is asked of a function and remembers where.
struct Asked {
  std::vector<VectorXd> points;
  int jacobians = 0;
};

inline LeastSquares least_squares(const PlainFunction& function, const VectorXd& start, double bound,
                                  Asked& asked) {
  return {.start = start,
          .lower = VectorXd::Constant(start.size(), -bound),
          .upper = VectorXd::Constant(start.size(), bound),
          .residuals =
              [&asked, function](const VectorXd& x) {
                asked.points.push_back(x);
                return function.residuals(x);
              },
          .jacobian =
              [&asked, function] {
                ++asked.jacobians;
                return function.jacobian(asked.points.back());
              }};
}

/// A x - b
inline PlainFunction linear(const MatrixXd& a, const VectorXd& b) {
  return {[a, b](const VectorXd& x) -> VectorXd { return a * x - b; }, [a](const VectorXd&) { return a; }};
}

}  // namespace bondstatic::test
