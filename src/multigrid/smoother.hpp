// Two steps of Chebyshev's iteration on D^-1 K, D the diagonal blocks: it takes care of what clumps cannot
// follow.
//
// The eigenvalues of D^-1 K never exceed 2, on any level: a link's energy is at most twice the sum of the
// energies it would have if only the one end moved and only the other. So the upper bound needs no estimate.
#pragma once

#include "multigrid/level.hpp"

namespace bondstatic::multigrid {

/// x = p(D^-1 K) D^-1 r from x = 0; r becomes the residual.
template <class Scalar>
void smooth_from_zero(Level<Scalar>& level, int threads);

/// The same once more after x has been changed by e, of which r knows nothing yet. r and e are of no further
/// use.
template <class Scalar>
void smooth_after_step(Level<Scalar>& level, int threads);

extern template void smooth_from_zero(Level<float>&, int);
extern template void smooth_from_zero(Level<double>&, int);
extern template void smooth_after_step(Level<float>&, int);
extern template void smooth_after_step(Level<double>&, int);

}  // namespace bondstatic::multigrid
