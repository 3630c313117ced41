#include "results/quantities.hpp"

#include <algorithm>

namespace bondstatic {

namespace {

template <class Quantity>
const Quantity* find(const std::vector<Quantity>& quantities, const std::string& name) {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const Quantity& quantity) { return quantity.name == name; });
  return found == quantities.end() ? nullptr : &*found;
}

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
  return find(particle_quantities(), name);
}

const BondQuantity* find_bond_quantity(const std::string& name) {
  return find(bond_quantities(), name);
}

}  // namespace bondstatic
