// Infinitesimal rigid motions of a body as screws.
#pragma once

#include <vector>

#include "bondstatic/mechanism.hpp"

namespace bondstatic {

/// Screw of the motion (v at `centre`, size * omega).
FreeMotion screw(const Vector6& scaled_motion, const Vector3& centre, double size);

/// The same space of scaled motions in a basis that reads well: rotations about x, y, z first, as far as they
/// are free, translations after. Returns fewer where the motions are not independent.
std::vector<Vector6> legible_basis(const std::vector<Vector6>& scaled_motions);

}  // namespace bondstatic
