// Null space of a sparse matrix of constraints on rigid bodies: a multifrontal QR factorisation on nested
// dissection of the bodies, with column pivoting inside each front. Only orthogonal transformations touch the
// constraints, never their normal equations, whose rounding would hide the difference between soft and free.
#pragma once

#include <utility>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// at_a . (motion of a) + at_b . (motion of b) = 0; a < 0 is the ground. Motions are scaled to one unit, rows
/// have unit length.
struct ConstraintRow {
  Index a = -1;
  Index b = 0;
  Vector6 at_a = Vector6::Zero();
  Vector6 at_b = Vector6::Zero();
};

/// The bodies that move and their motions.
using NullVector = std::vector<std::pair<Index, Vector6>>;

/// Motion is free where it costs at most this much strain: positions rounded to 1e-16 give 1e-15 or so times
/// the ratio of body sizes, a lever arm of 1e-6 of its body 1e-6.
inline constexpr double free_strain = 1e-9;

/// A basis in reduced echelon form: each vector has a degree of freedom that is zero in all others, hence
/// mechanisms that share no body come apart. `centres` of the bodies guide the dissection only.
std::vector<NullVector> null_space(const std::vector<Vector3>& centres,
                                   const std::vector<ConstraintRow>& rows);

}  // namespace bondstatic
