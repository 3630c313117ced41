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

}  // namespace

const std::vector<ParticleQuantity>& particle_quantities() {
  using Row = const ParticleRow&;
  static const std::vector<ParticleQuantity> table{
      {"x", "position", [](Row r) { return r.particle.position.x(); }},
      {"y", "position", [](Row r) { return r.particle.position.y(); }},
      {"z", "position", [](Row r) { return r.particle.position.z(); }},
      {"radius", "radius of the particle", [](Row r) { return r.particle.radius; }},
      {"ux", "displacement", [](Row r) { return r.displacement[0]; }},
      {"uy", "displacement", [](Row r) { return r.displacement[1]; }},
      {"uz", "displacement", [](Row r) { return r.displacement[2]; }},
      {"rx", "rotation, radians", [](Row r) { return r.displacement[3]; }},
      {"ry", "rotation, radians", [](Row r) { return r.displacement[4]; }},
      {"rz", "rotation, radians", [](Row r) { return r.displacement[5]; }},
      {"reaction_fx", "force of the support on the particle", [](Row r) { return r.reaction[0]; }},
      {"reaction_fy", "force of the support on the particle", [](Row r) { return r.reaction[1]; }},
      {"reaction_fz", "force of the support on the particle", [](Row r) { return r.reaction[2]; }},
      {"reaction_mx", "moment of the support on the particle", [](Row r) { return r.reaction[3]; }},
      {"reaction_my", "moment of the support on the particle", [](Row r) { return r.reaction[4]; }},
      {"reaction_mz", "moment of the support on the particle", [](Row r) { return r.reaction[5]; }},
      {"u", "magnitude of the displacement", [](Row r) { return r.displacement.head<3>().stableNorm(); },
       false},
      {"rotation", "magnitude of the rotation, radians",
       [](Row r) { return r.displacement.tail<3>().stableNorm(); }, false},
  };
  return table;
}

const std::vector<BondQuantity>& bond_quantities() {
  using Row = const BondResult&;
  static const std::vector<BondQuantity> table{
      {"fx", "force of the bond on particle b", [](Row r) { return r.force[0]; }},
      {"fy", "force of the bond on particle b", [](Row r) { return r.force[1]; }},
      {"fz", "force of the bond on particle b", [](Row r) { return r.force[2]; }},
      {"mx", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[3]; }},
      {"my", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[4]; }},
      {"mz", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[5]; }},
      {"normal_force", "along the bond, positive in tension", [](Row r) { return r.normal_force; }},
      {"shear_force", "magnitude, across the bond", [](Row r) { return r.shear_force; }},
      {"twisting_moment", "about the bond's axis from a to b", [](Row r) { return r.twisting_moment; }},
      {"bending_moment", "magnitude, at the contact point", [](Row r) { return r.bending_moment; }},
      {"sigma", "largest normal stress, tension positive", [](Row r) { return r.sigma; }},
      {"tau", "largest shear stress", [](Row r) { return r.tau; }},
      {"energy", "strain energy of the bond", [](Row r) { return r.energy; }},
  };
  return table;
}

double value_at(const ParticleQuantity& quantity, const Model& model, const State& state, Index particle) {
  const auto p = std::size_t(particle);
  return quantity.of({model.particles[p], state.displacement[p], state.reaction[p]});
}

const ParticleQuantity* find_particle_quantity(const std::string& name) {
  return find(particle_quantities(), name);
}

const BondQuantity* find_bond_quantity(const std::string& name) {
  return find(bond_quantities(), name);
}

}  // namespace bondstatic
