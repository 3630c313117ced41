#include "mechanism/constraint.hpp"

namespace bondstatic {

bool is_shifted(const Link& link, const Vector3& position_a, const Vector3& position_b) {
  return (position_b - position_a - link.branch).norm() > 1e-6 * link.branch.norm();
}

bool is_rigid(const Link& link, const Vector3& position_a, const Vector3& position_b) {
  return link.stiffness.full_rank() && !is_shifted(link, position_a, position_b);
}

void append_constraints(std::vector<Constraint>& constraints, const Link& link, Index a, Index b,
                        const Vector3& position_a, const Vector3& position_b) {
  const SectionStiffness& c = link.stiffness;
  const Vector3 x = bond_axis<double>(link), y = x.unitOrthogonal(), z = x.cross(y), none = Vector3::Zero();
  Constraint row{.a = a, .b = b, .at_a = position_a + link.fraction * link.branch};
  row.shifted = is_shifted(link, position_a, position_b);
  row.at_b = row.shifted ? Vector3(position_b - (1 - link.fraction) * link.branch) : row.at_a;
  const auto add = [&](const Vector3& force, const Vector3& moment) {
    row.force = force, row.moment = moment;
    constraints.push_back(row);
  };
  if (c.kn > 0) add(x, none);
  if (c.kt > 0) add(none, x);
  if (c.coupling != 0 && !(c.ks * c.kb > c.coupling * c.coupling)) {
    // Rank one in each bending plane: q_y = ks dy + c drz = 0 makes m_z vanish too; likewise q_z = ks dz - c
    // dry.
    add(y, c.coupling / c.ks * z);
    add(z, -c.coupling / c.ks * y);
    return;
  }
  if (c.ks > 0) add(y, none), add(z, none);
  if (c.kb > 0) add(none, y), add(none, z);
}

void append_support(std::vector<Constraint>& constraints, Index body, const Vector3& position,
                    std::uint8_t free) {
  for (int dof = 0; dof < 6; ++dof) {
    if ((free >> dof) & 1) continue;
    Constraint row{.a = ground, .b = body, .at_a = position, .at_b = position};
    (dof < 3 ? row.force : row.moment)[dof % 3] = 1;
    constraints.push_back(row);
  }
}

Vector6 wrench_on(const Constraint& constraint, const Vector3& at, const Vector3& centre, double size) {
  Vector6 row;
  row.head<3>() = constraint.force;
  row.tail<3>() = (constraint.moment + (at - centre).cross(constraint.force)) / size;
  return row;
}

}  // namespace bondstatic
