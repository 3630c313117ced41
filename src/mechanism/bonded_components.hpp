// Particles that bonds connect, whatever the bonds carry.
#pragma once

#include <vector>

#include "bondstatic/network.hpp"

namespace bondstatic {

/// Connected components of the particles that are `present`, each ascending, in the order of their first
/// particle. A bond to an absent particle connects nothing.
std::vector<std::vector<Index>> bonded_components(const BondNetwork& network,
                                                  const std::vector<bool>& present);

/// Does any particle of the component have a prescribed degree of freedom?
bool is_held(const std::vector<Index>& component, const FreeDofs& dofs);

}  // namespace bondstatic
