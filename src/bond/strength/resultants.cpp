#include "bond/strength/resultants.hpp"

namespace bondstatic {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// One mode along held + factor * scaled: convex, so it is below 1 on one interval.
struct Line {
  const FailureMode& mode;
  double normal[2], twisting[2];
  Eigen::Vector2d shear[2], bending[2];

  Line(const FailureMode& of, double length, double fraction, const SectionVector& held,
       const SectionVector& scaled)
      : mode(of),
        normal{held.normal, scaled.normal},
        twisting{held.twisting, scaled.twisting},
        shear{held.shear, scaled.shear},
        bending{bending_at(of.at, length, fraction, held), bending_at(of.at, length, fraction, scaled)} {}

  /// d|v|/dfactor, from the right where v vanishes.
  static double growth(const Eigen::Vector2d& v, const Eigen::Vector2d& direction) {
    const double size = v.norm();
    return size > 0 ? v.dot(direction) / size : direction.norm();
  }

  /// Sum and its slope.
  std::pair<double, double> at(double factor) const {
    const double n = normal[0] + factor * normal[1], t = twisting[0] + factor * twisting[1];
    const Eigen::Vector2d s = shear[0] + factor * shear[1], m = bending[0] + factor * bending[1];
    const double turning = t > 0 ? twisting[1] : t < 0 ? -twisting[1] : std::abs(twisting[1]);
    return {mode.normal * n + mode.shear * s.norm() + mode.twisting * std::abs(t) + mode.bending * m.norm(),
            mode.normal * normal[1] + mode.shear * growth(s, shear[1]) + mode.twisting * turning +
                mode.bending * growth(m, bending[1])};
  }

  /// Of a mode below 1 at `from`.
  double crossing(double from) const {
    const double slope = mode.normal * normal[1] + mode.shear * shear[1].norm() +
                         mode.twisting * std::abs(twisting[1]) + mode.bending * bending[1].norm();
    if (!(slope > 0)) return never;  // it never rises faster than at infinity
    const double opposed = mode.shear * shear[0].norm() + mode.twisting * std::abs(twisting[0]) +
                           mode.bending * bending[0].norm();
    // |held + factor scaled| >= factor |scaled| - |held|: at this factor the sum is 1 or more.
    double factor = (1 - mode.normal * normal[0] + opposed) / slope;
    if (!(factor < never)) return never;
    // Newton's steps from the right of a convex function's root never pass it. With nothing opposed the sum
    // is a straight line from 0 on.
    while ((opposed > 0 || factor < 0) && factor > from) {
      const auto [sum, rise] = at(factor);
      if (!(sum > 1 && rise > 0)) break;
      const double next = factor - (sum - 1) / rise;
      if (!(next < factor)) break;
      factor = next;
    }
    return std::max(from, factor);
  }
};

}  // namespace

SectionVector section_vector(const Vector3& branch, const Vector6& q) {
  const Vector3 x = branch.normalized(), y = x.unitOrthogonal(), z = x.cross(y);
  const Vector3 force = q.head<3>(), moment = q.tail<3>();
  return {x.dot(force), x.dot(moment), {y.dot(force), z.dot(force)}, {y.dot(moment), z.dot(moment)}};
}

Utilisation utilisation(std::span<const FailureMode> modes, double length, double fraction,
                        const SectionVector& carried) {
  Utilisation worst;
  for (const FailureMode& mode : modes)
    if (const double sum = sum_of(mode, length, fraction, carried); sum > worst.value)
      worst = {sum, mode.name};
  return worst;
}

Crossing first_crossing(std::span<const FailureMode> modes, double length, double fraction,
                        const SectionVector& held, const SectionVector& scaled, double from) {
  const Utilisation start = utilisation(modes, length, fraction, along(held, scaled, from));
  if (start.value >= 1) return {from, start.mode};
  Crossing first;
  for (const FailureMode& mode : modes)
    if (const double factor = Line(mode, length, fraction, held, scaled).crossing(from);
        factor < first.factor)
      first = {factor, mode.name};
  return first;
}

}  // namespace bondstatic
