// One bond: relative motion, resultants, end forces, stiffness, energy and stress ([Chen2022] section 4.3,
// Table 8; sources in the README). B is shared by all laws, C is the law:
//
//     delta = B u,   q = C delta,   k = B^T C B,   energy = delta^T C delta / 2,
//
// and the bond acts on the centres of its two particles with -B^T q. All vectors are in global axes.
#pragma once

#include <cmath>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// C of a bond that looks the same from all sides of its axis e_x (from a to b), as every round section does.
/// In the bond's own axes, with delta = (dx, dy, dz, drx, dry, drz):
///
///     q_x = kn dx     q_y = ks dy + c drz     q_z = ks dz - c dry
///     m_x = kt drx    m_y = kb dry - c dz     m_z = kb drz + c dy        (c = coupling)
///
/// kn, ks in force/length, kt, kb in force*length, c in force. Positive semi-definite: ks kb >= c^2.
struct SectionStiffness {
  double kn = 0;
  double ks = 0;
  double kt = 0;
  double kb = 0;
  double coupling = 0;  ///< only stepped sections couple shear and bending

  /// Resists every relative motion: kn, kt > 0 and ks kb > c^2.
  bool full_rank() const { return kn > 0 && kt > 0 && ks > 0 && kb > 0 && ks * kb > coupling * coupling; }
};

/// A bond as the solver sees it: two bodies, the contact point between them, and C.
struct Link {
  Index a = 0;
  Index b = 0;
  Vector3 branch = Vector3::Zero();  ///< from the centre of a to the centre of b
  double fraction = 0.5;             ///< contact point at fraction * branch from the centre of a
  SectionStiffness stiffness;
};

/// delta = (u_b - u_a) - (t theta_a + (1-t) theta_b) x branch, theta_b - theta_a: motion of b relative to a
/// at the contact point. It vanishes exactly for rigid motions, whatever the contact point.
template <class Scalar>
Vector6T<Scalar> relative_motion(const Link& link, const Vector6T<Scalar>& at_a,
                                 const Vector6T<Scalar>& at_b) {
  const Scalar t = link.fraction;
  const Vector3T<Scalar> theta_a = at_a.template tail<3>(), theta_b = at_b.template tail<3>();
  const Vector3T<Scalar> lever = t * theta_a + (1 - t) * theta_b;
  Vector6T<Scalar> delta;
  delta.template head<3>() =
      at_b.template head<3>() - at_a.template head<3>() - lever.cross(link.branch.cast<Scalar>());
  delta.template tail<3>() = theta_b - theta_a;
  return delta;
}

/// e_x: unit vector from a to b.
template <class Scalar>
Vector3T<Scalar> bond_axis(const Link& link) {
  return link.branch.cast<Scalar>().normalized();
}

/// q = C delta: force and moment at the contact point. q.e_x > 0 is tension; -q acts on b, +q acts on a.
template <class Scalar>
Vector6T<Scalar> resultants(const SectionStiffness& c, const Vector3T<Scalar>& axis,
                            const Vector6T<Scalar>& delta) {
  const Vector3T<Scalar> d = delta.template head<3>(), r = delta.template tail<3>();
  const Scalar kn = c.kn, ks = c.ks, kt = c.kt, kb = c.kb, coupling = c.coupling;
  const Scalar dx = axis.dot(d), rx = axis.dot(r);
  Vector6T<Scalar> q;
  // Axial and transverse parts apart: (kn - ks) e e^T would cancel where kn and ks differ by many decades.
  q.template head<3>() = kn * dx * axis + ks * (d - dx * axis);
  q.template tail<3>() = kt * rx * axis + kb * (r - rx * axis);
  if (c.coupling != 0) {
    q.template head<3>() -= coupling * axis.cross(r);
    q.template tail<3>() += coupling * axis.cross(d);
  }
  return q;
}

/// -B^T q at the centre of a: +force, moment with the lever arm fraction * branch.
template <class Scalar>
Vector6T<Scalar> force_on_a(const Link& link, const Vector6T<Scalar>& q) {
  const Scalar t = link.fraction;
  const Vector3T<Scalar> force = q.template head<3>(), branch = link.branch.cast<Scalar>();
  Vector6T<Scalar> p;
  p.template head<3>() = force;
  p.template tail<3>() = q.template tail<3>() + t * branch.cross(force);
  return p;
}

/// -B^T q at the centre of b: -force, moment with the lever arm (1 - fraction) * branch.
template <class Scalar>
Vector6T<Scalar> force_on_b(const Link& link, const Vector6T<Scalar>& q) {
  const Scalar t = link.fraction;
  const Vector3T<Scalar> force = q.template head<3>(), branch = link.branch.cast<Scalar>();
  Vector6T<Scalar> p;
  p.template head<3>() = -force;
  p.template tail<3>() = -q.template tail<3>() + (1 - t) * branch.cross(force);
  return p;
}

/// B (6x12) in global axes: delta = B (u_a, theta_a, u_b, theta_b).
Matrix6x12 relative_motion_matrix(const Link& link);

/// C (6x6) in global axes.
Matrix6 constitutive_matrix(const SectionStiffness& stiffness, const Vector3& axis);

/// k = B^T C B (12x12) in global axes; for the beam laws at fraction 1/2 this is [Chen2022] Eq. 14-25.
Matrix12 stiffness_matrix(const Link& link);

/// What a section carries at the contact point: normal force positive in tension, twisting moment about e_x,
/// magnitudes of the shear force and of the bending moment.
struct SectionForces {
  double normal = 0;
  double shear = 0;
  double twisting = 0;
  double bending = 0;
};

/// Largest normal and shear stress at the edge of a round section of radius r, tension positive ([EDEM-V2]):
/// sigma = Fn/A + 2 Mt r/J, tau = |Ft|/A + |Mn| r/J, with Mt the bending and Mn the twisting moment.
/// NaN where r is not positive (point bonds have no section).
struct SectionStress {
  double sigma = 0;
  double tau = 0;
};
SectionStress section_stress(const SectionForces& forces, double bond_radius);

}  // namespace bondstatic
