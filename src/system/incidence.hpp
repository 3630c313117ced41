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

/// Of any links that name their two bodies a and b.
template <class LinkType>
Incidence incidence_of(const std::vector<LinkType>& links, Index bodies) {
  Incidence incidence;
  incidence.offset.assign(std::size_t(bodies) + 1, 0);
  for (const LinkType& link : links) {
    ++incidence.offset[std::size_t(link.a) + 1];
    ++incidence.offset[std::size_t(link.b) + 1];
  }
  for (std::size_t p = 0; p < std::size_t(bodies); ++p) incidence.offset[p + 1] += incidence.offset[p];
  incidence.link.resize(2 * links.size());
  std::vector<Index> next(incidence.offset.begin(), incidence.offset.end() - 1);
  for (std::size_t k = 0; k < links.size(); ++k)
    for (const Index body : {links[k].a, links[k].b})
      incidence.link[std::size_t(next[std::size_t(body)]++)] = Index(k);
  return incidence;
}

Incidence link_incidence(const BondNetwork& network);

}  // namespace bondstatic
