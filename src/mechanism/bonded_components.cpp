#include "mechanism/bonded_components.hpp"

#include <algorithm>

#include "bondstatic/mechanism.hpp"
#include "mechanism/partition.hpp"

namespace bondstatic {

std::vector<std::vector<Index>> bonded_components(const BondNetwork& network,
                                                  const std::vector<bool>& present) {
  Partition sets(network.bodies);
  for (const Link& link : network.links)
    if (present[std::size_t(link.a)] && present[std::size_t(link.b)]) sets.unite(link.a, link.b);
  return sets.members([&](Index p) { return present[std::size_t(p)]; });
}

bool is_held(const std::vector<Index>& component, const FreeDofs& dofs) {
  constexpr std::uint8_t all_free = 0b111111;
  return std::any_of(component.begin(), component.end(),
                     [&](Index p) { return (dofs.free[std::size_t(p)] & all_free) != all_free; });
}

std::vector<std::vector<Index>> unsupported_bodies(const BondNetwork& network, const FreeDofs& dofs) {
  std::vector<std::vector<Index>> bodies;
  for (auto& component : bonded_components(network, std::vector<bool>(std::size_t(network.bodies), true)))
    if (!is_held(component, dofs)) bodies.push_back(std::move(component));
  return bodies;
}

}  // namespace bondstatic
