// What holds a model that lies in pieces.
#pragma once

#include "statics/held.hpp"
#include "statics/partners.hpp"

namespace bondstatic {

/// As held_by(), of load case `load_case`, by all ranks together; `network` is this rank's share. Bodies left
/// out are listed on rank 0. Where something can move without energy rank 0 asks for the whole model and
/// throws what held_by() does, and the others throw, too.
Held held_on_ranks(const Partners& partners, const BondNetwork& network, std::vector<std::uint8_t> free,
                   Index load_case, Unsupported unsupported);

}  // namespace bondstatic
