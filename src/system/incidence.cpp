#include "system/incidence.hpp"

namespace bondstatic {

Incidence link_incidence(const BondNetwork& network) {
  Incidence incidence;
  incidence.offset.assign(std::size_t(network.bodies) + 1, 0);
  for (const Link& link : network.links) {
    ++incidence.offset[std::size_t(link.a) + 1];
    ++incidence.offset[std::size_t(link.b) + 1];
  }
  for (std::size_t p = 0; p < std::size_t(network.bodies); ++p)
    incidence.offset[p + 1] += incidence.offset[p];
  incidence.link.resize(2 * network.links.size());
  std::vector<Index> next(incidence.offset.begin(), incidence.offset.end() - 1);
  for (std::size_t k = 0; k < network.links.size(); ++k)
    for (const Index body : {network.links[k].a, network.links[k].b})
      incidence.link[std::size_t(next[std::size_t(body)]++)] = Index(k);
  return incidence;
}

}  // namespace bondstatic
