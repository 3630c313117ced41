// One front of the null space: dense QR of [E B], with E's columns pivoted and its rank found.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

struct FrontFactor {
  Index rank = 0;
  std::vector<Index> order;  ///< columns of E: `rank` pivots first, then those that stay free
  Eigen::MatrixXd solved;    ///< R11 (upper triangle, rank x rank)
  Eigen::MatrixXd free;      ///< pivots = free * (free columns), rank x (columns of E - rank)
  Eigen::MatrixXd boundary;  ///< R12: rank x columns of B
  Eigen::MatrixXd rest;      ///< rows that bind the columns of B alone, for the parent
};

/// `matrix` = [E B], E being the first `eliminated` columns. A column is free where what is left of it, after
/// the pivots, is at most `tolerance`.
FrontFactor factorise_front(Eigen::MatrixXd matrix, Index eliminated, double tolerance);

}  // namespace bondstatic
