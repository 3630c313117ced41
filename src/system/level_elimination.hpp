// What a direct solver needs at most, from the graph alone.
#pragma once

#include "bondstatic/network.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

/// Operations of a block elimination along the levels of a breadth-first walk, bodies of one level at a time.
/// A chain, a beam or a wall has narrow levels and is told from a packing at once; nested dissection improves
/// on it by the ratio of the packing's length to a few bodies. Stops counting beyond `enough`.
double level_elimination_flops(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                               double enough);

}  // namespace bondstatic
