#include "bondstatic/network.hpp"

#include <bit>
#include <cmath>

#include "system/natural_form.hpp"

namespace bondstatic {

double rotation_length(double branches, double bonds) {
  if (!(branches > 0)) return 1;
  return std::exp2(std::round(std::log2(0.5 * branches / bonds)));
}

BondNetwork bond_network(const Model& model, std::span<const BondProperties> properties, int threads) {
  BondNetwork network;
  network.bodies = Index(model.particles.size());
  double branches = 0;
  for (const Bond& bond : model.bonds) branches += bond.branch.norm();
  network.rotation_length = rotation_length(branches, double(model.bonds.size()));
  network.links = vector_of<Link>(model.bonds.size(), threads);
  const Index bonds = Index(model.bonds.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bonds > worth_threads)
  for (Index i = 0; i < bonds; ++i) {
    const auto k = std::size_t(i);
    const Bond& bond = model.bonds[k];
    SectionStiffness stiffness = properties[k].stiffness;
    if (!properties[k].moments_fed_back) stiffness.kt = stiffness.kb = 0;
    network.links[k] = {bond.a, bond.b, bond.branch, properties[k].fraction, stiffness};
  }
  return network;
}

FreeDofs number_free_dofs(std::vector<std::uint8_t> free) {
  FreeDofs dofs;
  dofs.first.resize(free.size() + 1);
  dofs.first[0] = 0;
  for (std::size_t p = 0; p < free.size(); ++p)
    dofs.first[p + 1] = dofs.first[p] + std::popcount(std::uint8_t(free[p] & 0x3f));
  dofs.free = std::move(free);
  return dofs;
}

}  // namespace bondstatic
