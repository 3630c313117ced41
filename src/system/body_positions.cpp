#include "system/body_positions.hpp"

namespace bondstatic {

std::vector<Vector3> body_positions(const BondNetwork& network, const Incidence& incidence) {
  const auto bodies = std::size_t(network.bodies);
  std::vector<Vector3> position(bodies, Vector3::Zero());
  std::vector<bool> reached(bodies, false);
  std::vector<Index> part;
  for (std::size_t start = 0; start < bodies; ++start) {
    if (reached[start]) continue;
    part.assign(1, Index(start));
    reached[start] = true;
    Vector3 sum = Vector3::Zero();
    for (std::size_t next = 0; next < part.size(); ++next) {
      const Index p = part[next];
      sum += position[std::size_t(p)];
      for (const Index k : incidence.of(p)) {
        const Link& link = network.links[std::size_t(k)];
        const bool at_a = link.a == p;
        const auto other = std::size_t(at_a ? link.b : link.a);
        if (reached[other]) continue;
        reached[other] = true;
        position[other] = at_a ? Vector3(position[std::size_t(p)] + link.branch)
                               : Vector3(position[std::size_t(p)] - link.branch);
        part.push_back(Index(other));
      }
    }
    const Vector3 centre = sum / double(part.size());
    for (const Index p : part) position[std::size_t(p)] -= centre;
  }
  return position;
}

}  // namespace bondstatic
