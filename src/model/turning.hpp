// Rotations without loss of digits however small they are.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// Of a quaternion, at most pi long. By its vector part: the arc cosine of the scalar one knows no angle
/// below 1e-8.
inline Vector3 rotation_vector(const Eigen::Quaterniond& q) {
  const double sine = q.vec().norm();
  if (sine == 0) return Vector3::Zero();
  const double angle = 2 * std::atan2(sine, std::abs(q.w()));
  return (q.w() < 0 ? -angle : angle) / sine * q.vec();
}

/// The turn about `rotation` by its length, in radians.
inline Eigen::Quaterniond quaternion(const Vector3& rotation) {
  const double angle = rotation.norm();
  const Vector3 sine = angle > 0 ? Vector3(std::sin(angle / 2) / angle * rotation) : Vector3(0.5 * rotation);
  return {std::cos(angle / 2), sine.x(), sine.y(), sine.z()};
}

/// R v - v.
inline Vector3 turning(const Vector3& rotation, const Vector3& v) {
  const double angle = rotation.norm(), half = std::sin(angle / 2);
  const double first = angle > 0 ? std::sin(angle) / angle : 1;
  const double second = angle > 0 ? 2 * half / angle * half / angle : 0.5;
  const Vector3 across = rotation.cross(v);
  return first * across + second * rotation.cross(across);
}

}  // namespace bondstatic
