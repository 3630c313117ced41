#include "compare/finite_forces.hpp"

#include "model/turning.hpp"

namespace bondstatic {

namespace {

/// Lever arms from the two centres to where a bond holds them.
struct Grip {
  Vector3 arm_a, arm_b;
};

void put(PartForces& forces, StiffnessPart part, const Link& link, const Grip& grip, const Vector3& force,
         const Vector3& moment) {
  Vector6& on_a = forces[part][std::size_t(link.a)];
  Vector6& on_b = forces[part][std::size_t(link.b)];
  on_a.head<3>() -= force;
  on_a.tail<3>() -= moment + grip.arm_a.cross(force);
  on_b.head<3>() += force;
  on_b.tail<3>() += moment - grip.arm_b.cross(force);
}

void add_bond(PartForces& forces, const Link& link, const Vector6& at_a, const Vector6& at_b,
              const Matrix3& strain) {
  const SectionStiffness& c = link.stiffness;
  const Vector3 turn_a = at_a.tail<3>(), turn_b = at_b.tail<3>();
  const Vector3 to_a = link.fraction * link.branch, to_b = (1 - link.fraction) * link.branch;
  const Vector3 apart = at_b.head<3>() - at_a.head<3>() + strain * link.branch;
  const Vector3 moved_a = turning(turn_a, to_a), moved_b = turning(turn_b, to_b);
  const Vector3 branch = link.branch + apart, axis = branch.normalized();
  const Vector3 gap = apart - moved_a - moved_b;
  const double stretch =
      (2 * link.branch + apart).dot(apart) / (branch.norm() + link.branch.norm());  // no cancellation
  const Vector3 slip = gap - gap.dot(axis) * axis;
  const Vector3 turn = rotation_vector(quaternion(turn_b) * quaternion(turn_a).conjugate());
  const double twist = turn.dot(axis);
  const Vector3 bend = turn - twist * axis;

  // The two contact points, one on each particle, part by `gap`: forces act half way, or moments would be
  // lost.
  const Grip grip{to_a + moved_a + gap / 2, to_b + moved_b + gap / 2};
  const Vector3 none = Vector3::Zero();
  put(forces, normal_part, link, grip, c.kn * stretch * axis, none);
  put(forces, shear_part, link, grip, c.ks * slip - c.coupling * axis.cross(turn),
      c.coupling * axis.cross(slip));
  put(forces, twisting_part, link, grip, none, c.kt * twist * axis);
  put(forces, bending_part, link, grip, none, c.kb * bend);
}

}  // namespace

PartForces finite_forces(const BondNetwork& network, const BodyVectors<double>& motion,
                         const Matrix3& strain) {
  PartForces forces;
  for (auto& part : forces) part.assign(std::size_t(network.bodies), Vector6::Zero());
  for (const Link& link : network.links)
    add_bond(forces, link, motion[std::size_t(link.a)], motion[std::size_t(link.b)], strain);
  return forces;
}

BodyVectors<double> sum_of(const PartForces& parts) {
  BodyVectors<double> sum = parts.front();
  for (std::size_t part = 1; part < stiffness_parts; ++part)
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += parts[part][p];
  return sum;
}

}  // namespace bondstatic
