// Hinges, rings and floppy networks between rigid bodies.
#pragma once

#include <vector>

#include "bondstatic/mechanism.hpp"
#include "mechanism/rigid_bodies.hpp"

namespace bondstatic {

/// Every motion of the bodies that no constraint forbids; motions that move a common body share a mechanism,
/// of Kind::internal. `members`: particles of each body that a constraint names.
std::vector<Mechanism> internal_mechanisms(const Model& model, std::vector<std::vector<Index>> members,
                                           std::vector<Constraint> constraints);

}  // namespace bondstatic
