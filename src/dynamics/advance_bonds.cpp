#include "dynamics/advance_bonds.hpp"

#include <cmath>

#include "dynamics/vec3.hpp"
#include "io/wide.hpp"

namespace bondstatic {

namespace {

ALWAYS_INLINE Vec3 get(const Lanes (&lanes)[3], int lane) {
  return {lanes[0].at[lane], lanes[1].at[lane], lanes[2].at[lane]};
}

ALWAYS_INLINE void put(Lanes (&lanes)[3], int lane, const Vec3& value) {
  lanes[0].at[lane] = value.x;
  lanes[1].at[lane] = value.y;
  lanes[2].at[lane] = value.z;
}

struct Axes {
  Vec3 x, y, z;
};

ALWAYS_INLINE Vec3 in_axes(const Axes& e, const Vec3& v) {
  return {dot(e.x, v), dot(e.y, v), dot(e.z, v)};
}

ALWAYS_INLINE Vec3 in_space(const Axes& e, const Vec3& v) {
  return v.x * e.x + v.y * e.y + v.z * e.z;
}

/// e_y as the bond turns from axis `e0` to `e1` by the shortest way and then, about e1, by the angle
/// `2 half_twist` (to third order).
ALWAYS_INLINE Vec3 carried_side(const Vec3& side, const Vec3& e0, const Vec3& e1, double half_twist) {
  const Vec3 turned = side - (dot(side, e1) / (1 + dot(e0, e1))) * (e0 + e1);
  const double norm = 1 / (1 + half_twist * half_twist);
  const Vec3 twisted =
      ((1 - half_twist * half_twist) * norm) * turned + (2 * half_twist * norm) * cross(e1, turned);
  // Millions of steps would let rounding tilt and stretch it: put right to first order, which is all there
  // is.
  const Vec3 square = twisted - dot(twisted, e1) * e1;
  return (1.5 - 0.5 * dot(square, square)) * square;
}

/// The bond's geometry through one step: axes before, after, and their mean, in which increments are taken (a
/// rigid motion then makes none), branch and contact point halfway.
struct StepGeometry {
  Axes after, mean;
  Vec3 branch;          ///< halfway
  double fraction;      ///< contact point halfway, as a fraction of the branch
  double arm_a, arm_b;  ///< lever arms after the step
};

ALWAYS_INLINE StepGeometry frozen(const BondPack& p, int l) {
  const Vec3 x = get(p.axis, l), y = get(p.side, l);
  const Axes axes{x, y, cross(x, y)};
  const double arm = p.start_arm.at[l], length = p.start_length.at[l];
  return {axes, axes, get(p.branch, l), arm / length, arm, length - arm};
}

ALWAYS_INLINE StepGeometry followed(BondPack& p, const EndMotions& m, int l, double dt) {
  const Vec3 e0 = get(p.axis, l), y0 = get(p.side, l);
  const Vec3 branch = get(p.branch, l) + (get(m.displacement_b, l) - get(m.displacement_a, l));
  const Vec3 moved = dt * (get(m.velocity_b, l) - get(m.velocity_a, l));
  const double length0 = p.length.at[l], length = std::sqrt(dot(branch, branch));
  const Vec3 e1 = (1 / length) * branch;
  const Vec3 spin = get(m.spin_a, l) + get(m.spin_b, l);
  const Vec3 y1 = carried_side(y0, e0, e1, 0.125 * dt * dot(spin, e0 + e1));
  const Axes before{e0, y0, cross(e0, y0)}, after{e1, y1, cross(e1, y1)};
  put(p.axis, l, e1);
  put(p.side, l, y1);
  p.length.at[l] = length;

  const double stretch0 = length0 - p.start_length.at[l], stretch = length - p.start_length.at[l];
  const double arm = p.start_arm.at[l] + p.share.at[l] * stretch;  // Eq. 1-2
  const double mean_arm = p.start_arm.at[l] + 0.5 * p.share.at[l] * (stretch0 + stretch);
  return {after,
          {0.5 * (before.x + after.x), 0.5 * (before.y + after.y), 0.5 * (before.z + after.z)},
          branch - 0.5 * moved,
          mean_arm / (0.5 * (length0 + length)),
          arm,
          length - arm};
}

/// Eq. 4-7 in the mean axes of the step: a's velocity less b's at the contact point, and a's spin less b's.
struct RelativeVelocity {
  Vec3 v, w;
};

ALWAYS_INLINE RelativeVelocity relative_velocity(const StepGeometry& g, const EndMotions& m, int l) {
  const Vec3 spin_a = get(m.spin_a, l), spin_b = get(m.spin_b, l);
  const Vec3 from_a = g.fraction * g.branch, from_b = from_a - g.branch;
  const Vec3 at_a = get(m.velocity_a, l) + cross(spin_a, from_a);
  const Vec3 at_b = get(m.velocity_b, l) + cross(spin_b, from_b);
  return {in_axes(g.mean, at_a - at_b), in_axes(g.mean, spin_a - spin_b)};
}

/// Table 8, left column; the coupling of stepped sections is this program's own.
ALWAYS_INLINE void add_increments(BondPack& p, const RelativeVelocity& r, int l, double dt) {
  const double c = p.coupling.at[l];
  p.force[0].at[l] += p.kn.at[l] * r.v.x * dt;
  p.force[1].at[l] += (p.ks.at[l] * r.v.y + c * r.w.z) * dt;
  p.force[2].at[l] += (p.ks.at[l] * r.v.z - c * r.w.y) * dt;
  p.moment[0].at[l] += p.kt.at[l] * r.w.x * dt;
  p.moment[1].at[l] += (p.kb.at[l] * r.w.y - c * r.v.z) * dt;
  p.moment[2].at[l] += (p.kb.at[l] * r.w.z + c * r.v.y) * dt;
}

/// Table 8, right column: F_beta = F_c, F_alpha = -F_c, moments with both lever arms.
ALWAYS_INLINE void put_ends(EndForces& ends, const StepGeometry& g, Vec3 force, Vec3 moment, double feedback,
                            int l) {
  const Vec3 lever{0, -force.z, force.y};  // e_x cross F_c
  const Vec3 m = feedback * moment;
  put(ends.force, l, in_space(g.after, force));
  put(ends.moment_a, l, in_space(g.after, Vec3{-m.x, -m.y - g.arm_a * lever.y, -m.z - g.arm_a * lever.z}));
  put(ends.moment_b, l, in_space(g.after, Vec3{m.x, m.y - g.arm_b * lever.y, m.z - g.arm_b * lever.z}));
}

template <Kinematics kinematics>
ALWAYS_INLINE void advance_lane(BondPack& p, const EndMotions& m, double dt, EndForces& ends, int l) {
  const StepGeometry g = kinematics == Kinematics::finite ? followed(p, m, l, dt) : frozen(p, l);
  add_increments(p, relative_velocity(g, m, l), l, dt);
  put_ends(ends, g, get(p.force, l), get(p.moment, l), p.feedback.at[l], l);
}

template <Kinematics kinematics>
ALWAYS_INLINE void advance_lane(BondPack& p, DashpotPack& d, const EndMotions& m, double dt, EndForces& ends,
                                Lanes& dissipated, int l) {
  const StepGeometry g = kinematics == Kinematics::finite ? followed(p, m, l, dt) : frozen(p, l);
  const RelativeVelocity r = relative_velocity(g, m, l);
  add_increments(p, r, l, dt);
  const Vec3 force{d.cn.at[l] * r.v.x, d.cs.at[l] * r.v.y, d.cs.at[l] * r.v.z};   // Eq. 9
  const Vec3 moment{d.ct.at[l] * r.w.x, d.cb.at[l] * r.w.y, d.cb.at[l] * r.w.z};  // Eq. 10
  // Trapezoid over the step, as the central differences see it.
  dissipated.at[l] =
      0.5 * dt * (dot(get(d.force, l) + force, r.v) + p.feedback.at[l] * dot(get(d.moment, l) + moment, r.w));
  put(d.force, l, force);
  put(d.moment, l, moment);
  put_ends(ends, g, get(p.force, l) + force, get(p.moment, l) + moment, p.feedback.at[l], l);
}

WIDE_AS_THE_MACHINE void advance_small(BondPack& p, const EndMotions& m, double dt, EndForces& ends) {
#pragma omp simd
  for (int l = 0; l < pack_size; ++l) advance_lane<Kinematics::small>(p, m, dt, ends, l);
}

WIDE_AS_THE_MACHINE void advance_finite(BondPack& p, const EndMotions& m, double dt, EndForces& ends) {
#pragma omp simd
  for (int l = 0; l < pack_size; ++l) advance_lane<Kinematics::finite>(p, m, dt, ends, l);
}

WIDE_AS_THE_MACHINE void advance_small(BondPack& p, DashpotPack& d, const EndMotions& m, double dt,
                                       EndForces& ends, Lanes& dissipated) {
#pragma omp simd
  for (int l = 0; l < pack_size; ++l) advance_lane<Kinematics::small>(p, d, m, dt, ends, dissipated, l);
}

WIDE_AS_THE_MACHINE void advance_finite(BondPack& p, DashpotPack& d, const EndMotions& m, double dt,
                                        EndForces& ends, Lanes& dissipated) {
#pragma omp simd
  for (int l = 0; l < pack_size; ++l) advance_lane<Kinematics::finite>(p, d, m, dt, ends, dissipated, l);
}

}  // namespace

void advance_bonds(Kinematics kinematics, BondPack& pack, const EndMotions& motions, double dt,
                   EndForces& ends) {
  if (kinematics == Kinematics::finite)
    advance_finite(pack, motions, dt, ends);
  else
    advance_small(pack, motions, dt, ends);
}

void advance_bonds(Kinematics kinematics, BondPack& pack, DashpotPack& dashpots, const EndMotions& motions,
                   double dt, EndForces& ends, Lanes& dissipated) {
  if (kinematics == Kinematics::finite)
    advance_finite(pack, dashpots, motions, dt, ends, dissipated);
  else
    advance_small(pack, dashpots, motions, dt, ends, dissipated);
}

}  // namespace bondstatic
