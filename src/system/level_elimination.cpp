#include "system/level_elimination.hpp"

#include <vector>

namespace bondstatic {

double level_elimination_flops(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                               double enough) {
  std::vector<bool> seen(std::size_t(network.bodies), false);
  std::vector<Index> level, next;
  double flops = 0;
  const auto see = [&](Index p, std::vector<Index>& into) {
    if (seen[std::size_t(p)] || dofs.free[std::size_t(p)] == 0) return;
    seen[std::size_t(p)] = true;
    into.push_back(p);
  };
  for (Index start = 0; start < network.bodies && flops < enough; ++start) {
    level.clear();
    for (see(start, level); !level.empty() && flops < enough; level.swap(next)) {
      next.clear();
      for (const Index p : level)
        for (const Index k : incidence.of(p)) {
          const Link& link = network.links[std::size_t(k)];
          see(link.a == p ? link.b : link.a, next);
        }
      // Factorise the level, solve for what couples it to the next, and update that.
      const double here = 6 * double(level.size()), there = 6 * double(next.size());
      flops += here * here * here / 3 + here * here * there + here * there * there;
    }
  }
  return flops;
}

}  // namespace bondstatic
