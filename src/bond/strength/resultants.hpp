// The sums of failure modes along held + factor * scaled, inline: a fracture run asks for them at every bond
// after every break.
#pragma once

#include <cmath>
#include <span>

#include "bondstatic/strength.hpp"

namespace bondstatic {

/// Bending moment at `at`: what q, the bond's force and moment on a, is about that point (force_on_a).
inline Eigen::Vector2d bending_at(double at, double length, double fraction, const SectionVector& q) {
  const double arm = (fraction - at) * length;  // arm e_x x S
  return {q.bending.x() - arm * q.shear.y(), q.bending.y() + arm * q.shear.x()};
}

/// normal N + shear |S| + twisting |T| + bending |M|; may be negative.
inline double sum_of(const FailureMode& mode, double length, double fraction, const SectionVector& q) {
  return mode.normal * q.normal + mode.shear * q.shear.norm() + mode.twisting * std::abs(q.twisting) +
         mode.bending * bending_at(mode.at, length, fraction, q).norm();
}

inline SectionVector along(const SectionVector& held, const SectionVector& scaled, double factor) {
  return {held.normal + factor * scaled.normal, held.twisting + factor * scaled.twisting,
          held.shear + factor * scaled.shear, held.bending + factor * scaled.bending};
}

}  // namespace bondstatic
