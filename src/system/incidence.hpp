// Which links meet at a body: sums over them in a fixed order make every result independent of the thread
// count.
#pragma once

#include <span>
#include <vector>

#include "bondstatic/network.hpp"

namespace bondstatic {

struct Incidence {
  std::vector<Index> offset;  ///< size bodies + 1
  std::vector<Index> link;    ///< links of body p: link[offset[p]] ... ascending

  std::span<const Index> of(Index body) const {
    const auto p = std::size_t(body);
    return {link.data() + offset[p], std::size_t(offset[p + 1] - offset[p])};
  }
};

Incidence link_incidence(const BondNetwork& network);

}  // namespace bondstatic
