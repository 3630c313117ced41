// Links between rigid bodies, on every level: two bodies, the point between them where relative motion is
// taken, and a symmetric 6x6 stiffness there.
//
// A body moves with (U, Theta) of its centre; at a point `arm` away from the centre it moves with
//
//     G(arm) (U, Theta) = (U + Theta x arm, Theta).
//
// A link feels delta = G(arm_b) (U_b, Theta_b) - G(arm_a) (U_a, Theta_a) and answers with q = C delta: the
// energy of rigid motions is zero whatever the numbers, in float as in double. Moving the reference point by
// s takes C to S^T C S with S = G(-s), so that all the links between two clumps of bodies, each moved as one,
// add up to one link of the same kind: every level is a bonded packing again.
#pragma once

#include "bondstatic/bond.hpp"

namespace bondstatic::multigrid {

/// A bundle of bonds between two clumps; numbers in the precision that the level works in.
template <class Scalar>
struct RigidLink {
  Index a = 0;
  Index b = 0;
  Vector3T<Scalar> arm_a,
      arm_b;  ///< from the centres to the reference point; arm_a - arm_b is the branch vector
  Eigen::Matrix<Scalar, 6, 6> stiffness;
};

inline Vector3 arm_a(const Link& link) {
  return link.fraction * link.branch;
}
inline Vector3 arm_b(const Link& link) {
  return (link.fraction - 1) * link.branch;
}
inline Matrix6 stiffness_of(const Link& link) {
  return constitutive_matrix(link.stiffness, bond_axis<double>(link));
}

template <class Scalar>
Vector3 arm_a(const RigidLink<Scalar>& link) {
  return link.arm_a.template cast<double>();
}
template <class Scalar>
Vector3 arm_b(const RigidLink<Scalar>& link) {
  return link.arm_b.template cast<double>();
}
template <class Scalar>
Matrix6 stiffness_of(const RigidLink<Scalar>& link) {
  return link.stiffness.template cast<double>();
}

/// v -> v x: the matrix of the cross product from the left.
inline Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// G(arm)^T C G(arm): the stiffness C at a point, felt at a centre from which the point is `arm` away.
inline Matrix6 seen_from_centre(const Matrix6& c, const Vector3& arm) {
  const Matrix3 cross = cross_matrix(arm);
  const Matrix3 a = c.topLeftCorner<3, 3>(), b = c.topRightCorner<3, 3>();
  const Matrix3 a_cross = a * cross;
  Matrix6 result;
  result.topLeftCorner<3, 3>() = a;
  result.topRightCorner<3, 3>() = b - a_cross;
  const Matrix3 mixed = cross * b;  // and its transpose is -B^T [arm x]
  result.bottomRightCorner<3, 3>() =
      c.bottomRightCorner<3, 3>() + mixed + mixed.transpose() - cross * a_cross;
  result.bottomLeftCorner<3, 3>() = result.topRightCorner<3, 3>().transpose();
  return result;
}

/// Sums up what links do, felt at the centre of their first or their second body.
template <class LinkType>
class Felt {
 public:
  void add(const LinkType& link, bool first) {
    sum_ += seen_from_centre(stiffness_of(link), first ? arm_a(link) : arm_b(link));
  }
  const Matrix6& sum() const { return sum_; }

 private:
  Matrix6 sum_ = Matrix6::Zero();
};

/// The arms of a bond lie on its axis e, and with arm = t e
///
///     G^T C G has  kb + 2 t c + t^2 ks  for kb  and  c + t ks  for the coupling c:
///
/// a round section again, which couples by a cross product.
template <>
class Felt<Link> {
 public:
  void add(const Link& link, bool first) {
    const SectionStiffness& c = link.stiffness;
    const double length = link.branch.norm(), t = (first ? link.fraction : link.fraction - 1) * length;
    const Vector3 e = link.branch / length;
    const Matrix3 along = e * e.transpose(), across = Matrix3::Identity() - along;
    forces_ += c.kn * along + c.ks * across;
    moments_ += c.kt * along + (c.kb + t * (2 * c.coupling + t * c.ks)) * across;
    turn_ += (c.coupling + t * c.ks) * e;
  }
  Matrix6 sum() const {
    Matrix6 sum;
    sum << forces_, -cross_matrix(turn_), cross_matrix(turn_), moments_;
    return sum;
  }

 private:
  Matrix3 forces_ = Matrix3::Zero(), moments_ = Matrix3::Zero();
  Vector3 turn_ = Vector3::Zero();
};

}  // namespace bondstatic::multigrid
