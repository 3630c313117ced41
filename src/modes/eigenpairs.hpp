// Largest eigenvalues of a symmetric positive semi-definite operator that is known only by its products.
// Start vectors are fixed and all sums are serial: the same operator gives the same bits.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// y = A x; both have the size of the operator and do not overlap.
using Operator = std::function<void(const double* x, double* y)>;

struct EigenPairs {
  Eigen::VectorXd values;   ///< descending
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};

/// The `count` largest, 1 <= count <= n, each as often as it occurs. Throws AccuracyError where Lanczos does
/// not converge.
EigenPairs largest_eigenpairs(Index n, const Operator& apply, Index count);

struct DominantPair {
  double value = 0;
  double residual = 0;     ///< |A x - value x|: an eigenvalue lies no farther from `value`
  Eigen::VectorXd vector;  ///< of length one
};

/// The largest, n >= 1, to a residual of about `tolerance` times its value; as near as Lanczos gets where it
/// does not converge.
DominantPair dominant_eigenpair(Index n, const Operator& apply, double tolerance);

}  // namespace bondstatic
