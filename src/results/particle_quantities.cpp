#include "results/quantities.hpp"

namespace bondstatic {

namespace {

using Row = const ParticleRow&;
using Slope = ParticleSlope;

Slope no_slope(Row) {
  return ParticleSlope{};
}

template <int i>
Slope along_displacement(Row) {
  return ParticleSlope{Vector6::Unit(i), Vector6::Zero()};
}

template <int i>
Slope along_reaction(Row) {
  return ParticleSlope{Vector6::Zero(), Vector6::Unit(i)};
}

/// Of the magnitude of the three components of the displacement from `first`. What is exactly zero is held,
/// or stays so by symmetry.
template <int first>
Slope along_motion(Row r) {
  const Vector3 motion = r.displacement.segment<3>(first);
  ParticleSlope slope;
  if (!motion.isZero(0)) slope.displacement.segment<3>(first) = motion.stableNormalized();
  return slope;
}

}  // namespace

const std::vector<ParticleQuantity>& particle_quantities() {
  static const std::vector<ParticleQuantity> table{
      {"x", "position", [](Row r) { return r.particle.position.x(); }, no_slope},
      {"y", "position", [](Row r) { return r.particle.position.y(); }, no_slope},
      {"z", "position", [](Row r) { return r.particle.position.z(); }, no_slope},
      {"radius", "radius of the particle", [](Row r) { return r.particle.radius; }, no_slope},
      {"ux", "displacement", [](Row r) { return r.displacement[0]; }, along_displacement<0>},
      {"uy", "displacement", [](Row r) { return r.displacement[1]; }, along_displacement<1>},
      {"uz", "displacement", [](Row r) { return r.displacement[2]; }, along_displacement<2>},
      {"rx", "rotation, radians", [](Row r) { return r.displacement[3]; }, along_displacement<3>},
      {"ry", "rotation, radians", [](Row r) { return r.displacement[4]; }, along_displacement<4>},
      {"rz", "rotation, radians", [](Row r) { return r.displacement[5]; }, along_displacement<5>},
      {"reaction_fx", "force of the support on the particle", [](Row r) { return r.reaction[0]; },
       along_reaction<0>},
      {"reaction_fy", "force of the support on the particle", [](Row r) { return r.reaction[1]; },
       along_reaction<1>},
      {"reaction_fz", "force of the support on the particle", [](Row r) { return r.reaction[2]; },
       along_reaction<2>},
      {"reaction_mx", "moment of the support on the particle", [](Row r) { return r.reaction[3]; },
       along_reaction<3>},
      {"reaction_my", "moment of the support on the particle", [](Row r) { return r.reaction[4]; },
       along_reaction<4>},
      {"reaction_mz", "moment of the support on the particle", [](Row r) { return r.reaction[5]; },
       along_reaction<5>},
      {"u", "magnitude of the displacement", [](Row r) { return r.displacement.head<3>().stableNorm(); },
       along_motion<0>, false},
      {"rotation", "magnitude of the rotation, radians",
       [](Row r) { return r.displacement.tail<3>().stableNorm(); }, along_motion<3>, false},
  };
  return table;
}

}  // namespace bondstatic
