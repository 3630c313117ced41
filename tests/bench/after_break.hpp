// Ways to go on solving when bonds have broken: what src/fracture does, and what it could do.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "bondstatic/network.hpp"

namespace bondstatic::bench {

/// K' u = b of a network that loses link after link, without a factor of its own. One thread.
class AfterBreak {
 public:
  virtual ~AfterBreak() = default;
  /// A link of the network, with the stiffness that it has in K.
  virtual void take_out(const Link& link) = 0;
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) = 0;
  virtual int iterations() const { return 0; }  ///< of the last solve

  /// L in its own storage, beside which there may be more.
  double factor_bytes = 0;
  double ready_seconds = 0;  ///< beyond analysis and factorisation, before the first break
};

/// The factor itself is changed, by CHOLMOD's sparse downdate of a simplicial L D L^T.
std::unique_ptr<AfterBreak> by_downdates(const BondNetwork& network, const FreeDofs& dofs);

/// Woodbury's correction on the factor of K: fracture/low_rank_solver.hpp.
std::unique_ptr<AfterBreak> by_low_rank(const BondNetwork& network, const FreeDofs& dofs);

/// Conjugate gradients on the assembled K', with the factor of K as preconditioner, until the recurrence has
/// the residual below 1e-14 of b, 2-norm.
std::unique_ptr<AfterBreak> by_iteration(const BondNetwork& network, const FreeDofs& dofs);

}  // namespace bondstatic::bench
