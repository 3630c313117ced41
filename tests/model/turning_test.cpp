#include "model/turning.hpp"

#include <gtest/gtest.h>

namespace bondstatic {

namespace {

const Vector3 axis = Vector3(1, -2, 0.5).normalized();

TEST(Turning, RotationVectorKeepsItsDigitsAtTinyAngles) {
  for (const double angle : {1e-300, 1e-12, 1e-8, 1e-5, 0.1, 3.0}) {
    const Eigen::Quaterniond q(std::cos(angle / 2), std::sin(angle / 2) * axis.x(),
                               std::sin(angle / 2) * axis.y(), std::sin(angle / 2) * axis.z());
    EXPECT_LE((rotation_vector(q) - angle * axis).norm(), 4e-16 * angle) << angle;
  }
}

TEST(Turning, BothSignsOfAQuaternionAreOneRotation) {
  const Eigen::Quaterniond q = quaternion(0.3 * axis);
  const Eigen::Quaterniond other(-q.w(), -q.x(), -q.y(), -q.z());
  EXPECT_LE((rotation_vector(other) - rotation_vector(q)).norm(), 1e-16);
  EXPECT_EQ(rotation_vector(Eigen::Quaterniond::Identity()), Vector3(Vector3::Zero()));
}

TEST(Turning, QuaternionIsTheExponentialOfTheRotationVector) {
  EXPECT_TRUE(quaternion(Vector3::Zero()).isApprox(Eigen::Quaterniond::Identity(), 0));
  const Eigen::Quaterniond q = quaternion(Vector3(0, 0, EIGEN_PI / 2));
  EXPECT_DOUBLE_EQ(q.w(), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(q.z(), std::sqrt(0.5));
  // Small angles keep their digits, which an angle from w would lose.
  EXPECT_EQ(quaternion(Vector3(2e-12, 0, 0)).x(), 1e-12);
}

TEST(Turning, QuaternionAndRotationVectorAreInverse) {
  for (const double angle : {0.0, 1e-9, 0.7, 3.1})
    EXPECT_LE((rotation_vector(quaternion(angle * axis)) - angle * axis).norm(), 1e-15 * angle);
}

TEST(Turning, TurningIsWhatTheRotationAdds) {
  const Vector3 v(0.3, 0.1, -2);
  for (const double angle : {0.02, 1.5, 3.0}) {
    const Vector3 exact = Eigen::AngleAxisd(angle, axis) * v - v;
    EXPECT_LE((turning(angle * axis, v) - exact).norm(), 1e-15 * v.norm());
  }
  const Vector3 tiny = 1e-12 * axis;
  EXPECT_LE((turning(tiny, v) - tiny.cross(v)).norm(), 1e-11 * tiny.norm());
  EXPECT_EQ(turning(Vector3::Zero(), v), Vector3(Vector3::Zero()));
}

}  // namespace

}  // namespace bondstatic
