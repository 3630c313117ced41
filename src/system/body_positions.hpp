// Where the bodies of a network are, up to a translation of each connected part: branches added up along a
// breadth-first walk. Positions of the model are not known here, and would not do: in a periodic cell a
// branch may cross the boundary.
#pragma once

#include <vector>

#include "bondstatic/network.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

/// One position a body; each connected part has its centre at the origin. Around a periodic cell the walk
/// arrives from both sides, and bodies where they meet are neighbours in space by their own side only.
std::vector<Vector3> body_positions(const BondNetwork& network, const Incidence& incidence);

}  // namespace bondstatic
