#include <cmath>
#include <numbers>

#include "results/quantities.hpp"

namespace bondstatic {

namespace {

using Row = const BondResult&;
using Place = const BondRow&;
using Slope = std::optional<BondWeight>;

/// Below this part of the whole force (moment) a component is made of its rounding, and has no direction.
constexpr double no_direction = 1e-8;

Slope along(const Vector6& force) {
  BondWeight weight;
  weight.force = force;
  return weight;
}

template <int i>
Slope component(Place) {
  return along(Vector6::Unit(i));
}

/// What acts on b is -q: tension pulls it back along the axis.
Slope normal(Place p) {
  Vector6 force = Vector6::Zero();
  force.head<3>() = -p.axis;
  return along(force);
}

Slope twisting(Place p) {
  Vector6 moment = Vector6::Zero();
  moment.tail<3>() = p.axis;
  return along(moment);
}

/// Of the magnitude of the part across the axis of the three components from `first`. Exactly zero it is by
/// symmetry, or as the law has none: it stays so whatever the parameters.
template <int first>
Slope across(Place p) {
  if ((first == 0 ? p.result.shear_force : p.result.bending_moment) == 0) return along(Vector6::Zero());
  const Vector3 whole = p.result.force.segment<3>(first);
  const Vector3 part = whole - p.axis.dot(whole) * p.axis;
  if (!(part.stableNorm() > no_direction * whole.stableNorm())) return std::nullopt;
  Vector6 force = Vector6::Zero();
  force.segment<3>(first) = part.stableNormalized();
  return along(force);
}

// As section_stress() has them: sigma = N / (pi r^2) + 4 M / (pi r^3), tau = S / (pi r^2) + 2 |T| / (pi r^3).
Slope sigma(Place p) {
  const Slope bending = across<3>(p);
  if (!bending) return std::nullopt;
  const double r = p.radius, area = std::numbers::pi * r * r;
  Slope weight = along(normal(p)->force / area + 4 / (area * r) * bending->force);
  weight->radius = -(2 * p.result.normal_force + 12 / r * p.result.bending_moment) / (area * r);
  return weight;
}

Slope tau(Place p) {
  const Slope shear = across<0>(p);
  const double twist = p.result.twisting_moment;
  const bool rounding = std::abs(twist) <= no_direction * p.result.force.tail<3>().stableNorm();
  if (!shear || (rounding && twist != 0)) return std::nullopt;
  const double r = p.radius, area = std::numbers::pi * r * r;
  const double sign = twist == 0 ? 0 : std::copysign(1, twist);
  Slope weight = along(shear->force / area + sign * 2 / (area * r) * twisting(p)->force);
  weight->radius = -(2 * p.result.shear_force + 6 / r * std::abs(twist)) / (area * r);
  return weight;
}

Slope energy(Place) {
  BondWeight weight;
  weight.energy = 1;
  return weight;
}

}  // namespace

const std::vector<BondQuantity>& bond_quantities() {
  static const std::vector<BondQuantity> table{
      {"fx", "force of the bond on particle b", [](Row r) { return r.force[0]; }, component<0>},
      {"fy", "force of the bond on particle b", [](Row r) { return r.force[1]; }, component<1>},
      {"fz", "force of the bond on particle b", [](Row r) { return r.force[2]; }, component<2>},
      {"mx", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[3]; },
       component<3>},
      {"my", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[4]; },
       component<4>},
      {"mz", "moment of the bond on particle b, at the contact point", [](Row r) { return r.force[5]; },
       component<5>},
      {"normal_force", "along the bond, positive in tension", [](Row r) { return r.normal_force; }, normal},
      {"shear_force", "magnitude, across the bond", [](Row r) { return r.shear_force; }, across<0>},
      {"twisting_moment", "about the bond's axis from a to b", [](Row r) { return r.twisting_moment; },
       twisting},
      {"bending_moment", "magnitude, at the contact point", [](Row r) { return r.bending_moment; },
       across<3>},
      {"sigma", "largest normal stress, tension positive", [](Row r) { return r.sigma; }, sigma},
      {"tau", "largest shear stress", [](Row r) { return r.tau; }, tau},
      {"energy", "strain energy of the bond", [](Row r) { return r.energy; }, energy},
  };
  return table;
}

}  // namespace bondstatic
