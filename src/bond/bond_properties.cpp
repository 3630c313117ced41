#include <utility>

#include "bond/block_plan.hpp"

namespace bondstatic {

BondSite bond_site(const Model& model, const Bond& bond) {
  const Particle& a = model.particles.at(std::size_t(bond.a));
  const Particle& b = model.particles.at(std::size_t(bond.b));
  return {bond.branch.norm(), a.radius, b.radius, a.id, b.id};
}

std::vector<BondProperties> bond_properties(const Model& model, int threads) {
  std::vector<Fault> faults;
  std::vector<BlockPlan> plans;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    plans.push_back(plan_block(model.blocks[b], b, faults));

  std::vector<BondProperties> out(model.bonds.size());
  visit_pieces(Index(model.bonds.size()), threads, std::move(faults),
               [&](Index begin, Index end, Findings& findings) {
                 std::vector<double> scratch;
                 for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
                   const Bond& bond = model.bonds[k];
                   const BlockPlan& plan = plans.at(std::size_t(bond.block));
                   if (plan.law) evaluate(model, bond, plan, scratch, out[k], findings);
                 }
               });
  return out;
}

}  // namespace bondstatic
