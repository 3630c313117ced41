#include "multigrid/block_diagonal.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace bondstatic::multigrid {

namespace {

template <class Scalar>
ALWAYS_INLINE void multiply(const InversePack<Scalar>& pack, const Scalar* r, Scalar* z) {
  using W = Wide<Scalar>;
  static constexpr std::uint32_t body[pack_size] = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int lane = 0; lane < pack_size; lane += lanes<Scalar>) {
    const Bodies<Scalar> in = gather(r, body + lane);
    const W from[6] = {in.linear.x, in.linear.y, in.linear.z, in.angular.x, in.angular.y, in.angular.z};
    W to[6] = {};
    int entry = 0;
#pragma GCC unroll 6  // or `to` lies in memory
    for (int i = 0; i < 6; ++i)
#pragma GCC unroll 6
      for (int j = i; j < 6; ++j, ++entry) {
        const W c = load<Scalar>(pack.c[entry] + lane);
        to[i] += c * from[j];
        if (j > i) to[j] += c * from[i];
      }
    scatter({{to[0], to[1], to[2]}, {to[3], to[4], to[5]}}, z + stride * lane);
  }
}

template <class Scalar>
ALWAYS_INLINE void multiply_all(const InversePack<Scalar>* packs, std::size_t count, const Scalar* r,
                                Scalar* z) {
  for (std::size_t k = 0; k < count; ++k)
    multiply(packs[k], r + k * stride * pack_size, z + k * stride * pack_size);
}

}  // namespace

Matrix6 inverse_block(const Matrix6& block, std::uint8_t free) {
  // Brought to a unit diagonal: a body may be held by bonds that resist some motions a million times less.
  Vector6 scale;
  for (int i = 0; i < 6; ++i)
    scale[i] = ((free >> i) & 1) && block(i, i) > 0 ? 1 / std::sqrt(block(i, i)) : 0;
  Matrix6 unit = scale.asDiagonal() * block * scale.asDiagonal();
  if (scale.minCoeff() > 0) {
    constexpr double well_conditioned = 1e-4;
    const Eigen::LLT<Matrix6> factor(unit);
    if (factor.info() == Eigen::Success && factor.matrixLLT().diagonal().minCoeff() > well_conditioned) {
      Matrix6 half;  // L^-1, column by column: Eigen unrolls that
      for (int i = 0; i < 6; ++i) half.col(i) = factor.matrixL().solve(Vector6::Unit(i));
      half *= scale.asDiagonal();
      return half.transpose().lazyProduct(half);
    }
  }
  constexpr double rounding = 1e-13;
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(unit);
  const Vector6 inverse =
      eigen.eigenvalues().unaryExpr([](double value) { return value > rounding ? 1 / value : 0; });
  const Matrix6 back = scale.asDiagonal() * eigen.eigenvectors();
  return back * inverse.asDiagonal() * back.transpose();
}

WIDE_AS_THE_MACHINE void apply_inverse(const InversePack<float>* packs, std::size_t count, const float* r,
                                       float* z) {
  multiply_all(packs, count, r, z);
}
WIDE_AS_THE_MACHINE void apply_inverse(const InversePack<double>* packs, std::size_t count, const double* r,
                                       double* z) {
  multiply_all(packs, count, r, z);
}

}  // namespace bondstatic::multigrid
