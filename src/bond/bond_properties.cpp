#include <utility>

#include "bond/block_plan.hpp"
#include "bond/bond_radii.hpp"
#include "io/first_touch.hpp"

namespace bondstatic {

namespace {

/// Calls `take` with the position and the properties of every bond, of several at once.
template <class Take>
void evaluate_all(const Model& model, int threads, const Take& take) {
  std::vector<Fault> faults;
  std::vector<BlockPlan> plans;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    plans.push_back(plan_block(model.blocks[b], b, faults));

  visit_pieces(Index(model.bonds.size()), threads, std::move(faults),
               [&](Index begin, Index end, Findings& findings) {
                 std::vector<double> scratch;
                 for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
                   const Bond& bond = model.bonds[k];
                   const BlockPlan& plan = plans.at(std::size_t(bond.block));
                   BondProperties properties;
                   if (plan.law) evaluate(model, bond, plan, scratch, properties, findings);
                   take(k, properties);
                 }
               });
}

}  // namespace

BondSite bond_site(const Model& model, const Bond& bond) {
  const Particle& a = model.particles.at(std::size_t(bond.a));
  const Particle& b = model.particles.at(std::size_t(bond.b));
  return {bond.branch.norm(), a.radius, b.radius, a.id, b.id};
}

std::vector<BondProperties> bond_properties(const Model& model, int threads) {
  auto out = vector_of<BondProperties>(model.bonds.size(), threads);
  evaluate_all(model, threads, [&](std::size_t k, const BondProperties& of_bond) { out[k] = of_bond; });
  return out;
}

std::vector<double> bond_radii(const Model& model, int threads) {
  std::vector<double> radii(model.bonds.size());
  evaluate_all(model, threads,
               [&](std::size_t k, const BondProperties& of_bond) { radii[k] = of_bond.radius; });
  return radii;
}

}  // namespace bondstatic
