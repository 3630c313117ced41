#include "system/incidence.hpp"

namespace bondstatic {

Incidence link_incidence(const BondNetwork& network) {
  return incidence_of(network.links, network.bodies);
}

}  // namespace bondstatic
