// Fixed-size vectors and the index type that every room shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace bondstatic {

/// Counts and indices are 64 bits everywhere: packings of 10^7 particles have more than 2^31 matrix entries.
using Index = std::int64_t;

template <class Scalar>
using Vector3T = Eigen::Matrix<Scalar, 3, 1>;
/// Motion or force of one particle: (x, y, z, rx, ry, rz) or (fx, fy, fz, mx, my, mz), global axes.
template <class Scalar>
using Vector6T = Eigen::Matrix<Scalar, 6, 1>;

using Vector3 = Vector3T<double>;
using Vector6 = Vector6T<double>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix3 = Eigen::Matrix<double, 3, 3>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix6x12 = Eigen::Matrix<double, 6, 12>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

}  // namespace bondstatic
