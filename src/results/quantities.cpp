#include "results/quantities.hpp"

#include "results/find_named.hpp"

namespace bondstatic {

namespace {

ParticleRow row_of(const Model& model, const State& state, Index particle) {
  const auto p = std::size_t(particle);
  return {model.particles[p], state.displacement[p], state.reaction[p]};
}

}  // namespace

double value_at(const ParticleQuantity& quantity, const Model& model, const State& state, Index particle) {
  return quantity.of(row_of(model, state, particle));
}

ParticleSlope slope_at(const ParticleQuantity& quantity, const Model& model, const State& state,
                       Index particle) {
  return quantity.slope(row_of(model, state, particle));
}

std::optional<BondWeight> slope_at(const BondQuantity& quantity, const Model& model, const State& state,
                                   const std::vector<BondProperties>& properties, Index bond) {
  const auto k = std::size_t(bond);
  auto weight = quantity.slope({state.bonds[k], model.bonds[k].branch.normalized(), properties[k].radius});
  if (weight) weight->bond = bond;
  return weight;
}

const ParticleQuantity* find_particle_quantity(const std::string& name) {
  return find_named(particle_quantities(), name);
}

const BondQuantity* find_bond_quantity(const std::string& name) {
  return find_named(bond_quantities(), name);
}

}  // namespace bondstatic
