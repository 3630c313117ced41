// How certain the parameters of a least squares minimum are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/least_squares.hpp"

namespace bondstatic {

struct Intervals {
  Eigen::VectorXd half_width;   ///< of 95 %, scaled parameters; NaN where nothing tells
  Eigen::MatrixXd correlation;  ///< NaN there
};

/// `settled`: columns of the minimum's Jacobian that neither a bound nor an unseen direction touches;
/// `loose`: those that an unseen direction does, `unseen` directions in all. Where `known_errors`, residuals
/// are over standard deviations; else their common size is estimated with as many degrees of freedom as
/// residuals outnumber what was fitted, and without any nothing is certain. Residuals count by their weights
/// under the loss.
Intervals intervals(const Minimum& minimum, Loss loss, const std::vector<Eigen::Index>& settled,
                    const std::vector<Eigen::Index>& loose, Eigen::Index unseen, bool known_errors);

}  // namespace bondstatic
