// Conjugate gradients for a preconditioner that is not quite linear (Notay, SIAM J. Sci. Comput. 22, 2000):
// each direction is made conjugate to the one before it by the product at hand.
#pragma once

#include "multigrid/hierarchy.hpp"

namespace bondstatic::multigrid {

/// How far to go.
struct Goal {
  double energy_reduction = 1e-6;  ///< of sqrt(r . M r), M the cycle: the energy norm of the error within a
                                   ///< factor, expected of the last step from the one before it
  int most_iterations = 1000;
  int patience = 50;  ///< iterations without a new best: where float, or double, has no more to give
};

struct Convergence {
  int iterations = 0;
  double reduction = 1;  ///< 2-norm of the residual, after over before
  bool reached = false;
};

/// Solves K x = r in double, K with the numbers that the hierarchy holds. r is overwritten by the residual, x
/// is set; where the goal is not reached, x is as far as it got. Rows of copies in x are not up to date.
template <class Scalar>
Convergence flexible_cg(Hierarchy<Scalar>& hierarchy, const Goal& goal, int threads, Rows<double>& r,
                        Rows<double>& x);

extern template Convergence flexible_cg(Hierarchy<float>&, const Goal&, int, Rows<double>&, Rows<double>&);
extern template Convergence flexible_cg(Hierarchy<double>&, const Goal&, int, Rows<double>&, Rows<double>&);

}  // namespace bondstatic::multigrid
