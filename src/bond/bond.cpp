#include "bondstatic/bond.hpp"

#include <limits>
#include <numbers>

namespace bondstatic {

Matrix6x12 relative_motion_matrix(const Link& link) {
  Matrix6x12 b;
  for (int column = 0; column < 12; ++column) {
    const Vector12 u = Vector12::Unit(column);
    b.col(column) = relative_motion<double>(link, u.head<6>(), u.tail<6>());
  }
  return b;
}

Matrix6 constitutive_matrix(const SectionStiffness& stiffness, const Vector3& axis) {
  // Column by column what resultants() answers to a unit of relative motion, bit for bit.
  Matrix6 c;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const double along = axis[j] * axis[i], across = (i == j ? 1 : 0) - along;
      c(i, j) = stiffness.kn * axis[j] * axis[i] + stiffness.ks * across;
      c(i + 3, j + 3) = stiffness.kt * axis[j] * axis[i] + stiffness.kb * across;
    }
  Matrix3 turn;  // coupling e x
  turn << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  turn *= stiffness.coupling;
  c.topRightCorner<3, 3>() = -turn;
  c.bottomLeftCorner<3, 3>() = turn;
  return c;
}

Matrix12 stiffness_matrix(const Link& link) {
  // Column by column, as C as a matrix would spread the rounding of kn over the much smaller ks and kb.
  const Vector3 axis = bond_axis<double>(link);
  Matrix12 k;
  for (int column = 0; column < 12; ++column) {
    const Vector12 u = Vector12::Unit(column);
    const Vector6 delta = relative_motion<double>(link, u.head<6>(), u.tail<6>());
    const Vector6 q = resultants<double>(link.stiffness, axis, delta);
    k.col(column) << -force_on_a<double>(link, q), -force_on_b<double>(link, q);
  }
  return k;
}

SectionStress section_stress(const SectionForces& forces, double bond_radius) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(bond_radius > 0)) return {nan, nan};
  const double r = bond_radius, area = std::numbers::pi * r * r, polar = 0.5 * area * r * r;
  return {forces.normal / area + 2 * forces.bending * r / polar,
          std::abs(forces.shear) / area + std::abs(forces.twisting) * r / polar};
}

}  // namespace bondstatic
