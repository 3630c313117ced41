#include "multigrid/packing.hpp"

#include "system/together.hpp"

namespace bondstatic::multigrid {

namespace {

// How much stiffer than its links a particle's held degree of freedom is made for clumps. Three loses
// nothing: the preconditioner is off by a third at most in a few degrees of freedom. A hundred doubles the
// iterations where a packing stands on rollers, as a clump then hardly turns over them.
constexpr double spring_over_links = 3;

}  // namespace

Packing<Link> finest_packing(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                             std::vector<Spring>& springs, Halo& halo) {
  halo = network.share ? Halo{network.share->ranks, network.share->neighbours} : Halo{};
  Packing<Link> packing{
      network.bodies, network.own(), network.links, &incidence, {network.rotation_length, 0}, {}, {}, &halo};
  for (const Link& link : network.links)
    packing.units.stiffness = std::max({packing.units.stiffness, link.stiffness.kn, link.stiffness.ks});
  packing.units.stiffness = largest_of_all(halo.ranks, packing.units.stiffness);
  if (!(packing.units.stiffness > 0)) packing.units.stiffness = 1;
  packing.held.resize(std::size_t(network.bodies));
  springs.clear();
  for (Index p = 0; p < network.bodies; ++p) {
    const std::uint8_t free = dofs.free[std::size_t(p)];
    packing.held[std::size_t(p)] = free == 0;
    if (free == 0 || free == all_free || p >= packing.own) continue;
    Vector6 stiffness = spring_over_links * links_felt_at(packing, p).diagonal();
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(p, i)) stiffness[i] = 0;
    springs.push_back({p, stiffness.asDiagonal()});
  }
  packing.springs = springs;
  return packing;
}

}  // namespace bondstatic::multigrid
