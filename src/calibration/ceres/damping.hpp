// Ceres damps a Levenberg-Marquardt step by its trust region radius R, which multiplies the columns' squares
// by 1 + 1/R. How long the step becomes is known before anything is evaluated; far from the minimum of a
// stiffness' logarithm, or where solves fail, it must be short, and near it undamped.
#pragma once

#include <Eigen/Core>

namespace bondstatic {

struct Damping {
  double radius = 0;
  bool shortens = false;  ///< the step is shorter than undamped
  double undamped_length =
      0;            ///< largest change of an x by the undamped step, along what residuals tell apart
  double gain = 0;  ///< part of the residuals' squares that the undamped step would remove
};

/// The weakest damping with which no x moves by more than `longest`. Columns must not be zero.
Damping choose_damping(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals, double longest);

}  // namespace bondstatic
