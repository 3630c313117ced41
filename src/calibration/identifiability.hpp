// Which directions of the parameters the targets do not see, and what they do see of them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bondstatic/calibration.hpp"

namespace bondstatic {

/// Directions are seen where their singular value is more than this part of the largest, rows and columns of
/// the Jacobian scaled to length 1 (rows to no less than a millionth of the longest's).
inline constexpr double identified = 1e-8;

/// A point at which directions are looked at.
struct LookedAt {
  Eigen::MatrixXd jacobian;     ///< of the residuals, to the scaled parameters
  Eigen::VectorXd logarithmic;  ///< d(ln p) / d(scaled parameter); NaN where p <= 0
};

/// A direction of `columns` alone; sparse where several span the same.
struct UnseenDirection {
  Eigen::VectorXd direction;  ///< unit, of all parameters, zero but in `columns`
  bool no_influence = false;  ///< a single parameter that no residual depends on
};

std::vector<UnseenDirection> unseen_directions(const Eigen::MatrixXd& jacobian,
                                               const std::vector<Eigen::Index>& columns);

/// What a user is told of it. A product of powers is named where both points see the same one; else how
/// parameters make up for each other at the solution.
std::string sentence(const UnseenDirection& unseen, const std::vector<std::string>& names,
                     const LookedAt& start, const LookedAt& solution);

}  // namespace bondstatic
