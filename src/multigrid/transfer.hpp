// Between a level and the next coarser one: P moves each clump as one rigid body,
//
//     u = U + Theta x offset,   theta = Theta,
//
// and P^T adds up forces and moments about the clump's centre.
#pragma once

#include "multigrid/level.hpp"

namespace bondstatic::multigrid {

/// coarse.r = P^T fine.r.
template <class Scalar>
void gather_on_clumps(Level<Scalar>& fine, Level<Scalar>& coarse, int threads);

/// fine.e = factor P coarse.x, fine.x += fine.e.
template <class Scalar>
void move_with_clumps(const Level<Scalar>& coarse, Level<Scalar>& fine, double factor, int threads);

extern template void gather_on_clumps(Level<float>&, Level<float>&, int);
extern template void gather_on_clumps(Level<double>&, Level<double>&, int);
extern template void move_with_clumps(const Level<float>&, Level<float>&, double, int);
extern template void move_with_clumps(const Level<double>&, Level<double>&, double, int);

}  // namespace bondstatic::multigrid
