// Bodies whose joint leaves them no relative motion are one body; what is united may hold on to a third.
#pragma once

#include <vector>

#include "mechanism/constraint.hpp"
#include "mechanism/partition.hpp"

namespace bondstatic {

/// Sets of bodies 0 ... bodies-1 that can only move as one, the ground being number `bodies`. Two are united
/// where the singular values of all constraints between them are above 1e-3 (lengths in sizes of the joint),
/// that is beyond doubt; what is less clear-cut is left to the null space.
Partition grow_rigid(Index bodies, const std::vector<Constraint>& constraints);

}  // namespace bondstatic
