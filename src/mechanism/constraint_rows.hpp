// Constraints as rows of the matrix whose null space is sought.
#pragma once

#include <vector>

#include "mechanism/null_space.hpp"
#include "mechanism/rigid_bodies.hpp"

namespace bondstatic {

/// Rows of unit length on the bodies' scaled motions (v at the centre, size * omega). Constraints that say
/// nothing (a body held against its own image along the image shift) give no row.
std::vector<ConstraintRow> constraint_rows(const std::vector<RigidBody>& bodies,
                                           const std::vector<Constraint>& constraints);

}  // namespace bondstatic
