// Least squares within bounds, of plain functions: what is minimised, and what the minimum is. Knows nothing
// of models.
//
//     minimise  1/2 sum_i rho(r_i(x)^2)   over  lower <= x <= upper
//
// x are scaled so that a change of one is a large one: logarithms, or parts of a range.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "bondstatic/calibration.hpp"

namespace bondstatic {

struct LeastSquares {
  Eigen::VectorXd start, lower, upper;

  /// r(x); none where there is no answer, and a shorter step is to be tried. May throw.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& x)> residuals;

  /// dr/dx where residuals() was asked last, called only where that point is better than all before it, or
  /// the first. May throw.
  std::function<Eigen::MatrixXd()> jacobian;

  Loss loss = Loss::squares;
  int most_evaluations = 50;  ///< of residuals()
  double tolerance = 1e-12;   ///< on the step
};

enum class Ending {
  minimum,
  too_many_evaluations,
  stuck,  ///< no shorter step lowers the cost, although the derivatives say that there is one
};

/// The best point that was found.
struct Minimum {
  Ending ending = Ending::minimum;
  Eigen::VectorXd x, residuals;
  Eigen::MatrixXd jacobian;
  std::vector<bool> held;  ///< by a bound, against which the residuals pull
};

/// Levenberg-Marquardt by Ceres (S. Agarwal, K. Mierle & the Ceres Solver team). Throws what the functions
/// throw; Error (invalid_input) where Ceres is not there, or the start has no answer or none that is finite.
Minimum minimise(const LeastSquares& problem);

/// rho and its derivative. From `loss_width` of r on, large residuals count less; at these widths 95 % of the
/// efficiency of least squares is left where errors are normal (P. W. Holland & R. E. Welsch, Communications
/// in Statistics A6 (1977) 813).
double rho(Loss loss, double squared_residual);
double rho_slope(Loss loss, double squared_residual);
double loss_width(Loss loss);

/// 1/2 sum rho(r^2).
double cost(Loss loss, const Eigen::VectorXd& residuals);

/// rho'(r^2) of each residual: how much it still counts.
Eigen::VectorXd weights(Loss loss, const Eigen::VectorXd& residuals);

}  // namespace bondstatic
