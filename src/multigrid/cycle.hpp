// One cycle of the multigrid: an approximate K^-1 r.
//
// Smooth, move each clump as a whole by what the next coarser level says, smooth again. The coarser level is
// asked by two steps of flexible conjugate gradients with a cycle from there as preconditioner (K-cycle:
// Notay and Vassilevski, Numer. Linear Algebra Appl. 15, 2008), which keeps the iterations flat however many
// levels there are.
#pragma once

#include "multigrid/hierarchy.hpp"

namespace bondstatic::multigrid {

/// From levels.front().r to levels.front().x; r is overwritten.
template <class Scalar>
void cycle(Hierarchy<Scalar>& hierarchy, int threads);

extern template void cycle(Hierarchy<float>&, int);
extern template void cycle(Hierarchy<double>&, int);

}  // namespace bondstatic::multigrid
