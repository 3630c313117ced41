#include "statics/effective_stiffness.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "model/cell.hpp"
#include "system/extended.hpp"
#include "system/ranks.hpp"
#include "system/together.hpp"

namespace bondstatic {

namespace {

/// Weights of Voigt's components, with which the norm of a stiffness is that of the tensor (Mandel's
/// notation).
Matrix6 weighted(const Matrix6& stiffness) {
  Vector6 weight;
  weight << 1, 1, 1, std::sqrt(2.0), std::sqrt(2.0), std::sqrt(2.0);
  return weight.asDiagonal() * stiffness * weight.asDiagonal();
}

bool is_pure_strain(const Boundary& boundary) {
  const auto nothing = [](const Vector6& v) { return v.isZero(0); };
  return std::all_of(boundary.load.begin(), boundary.load.end(), nothing) &&
         std::all_of(boundary.prescribed.begin(), boundary.prescribed.end(), nothing);
}

/// Strain of each load case as a column; nothing where they are not six independent ones.
std::optional<Matrix6> six_strains(const std::vector<Boundary>& boundaries, Ranks* ranks) {
  const bool pure = std::all_of(boundaries.begin(), boundaries.end(), is_pure_strain);
  if (largest_of_all(ranks, pure ? 0.0 : 1.0) > 0 || boundaries.size() != 6) return std::nullopt;
  Matrix6 strains;
  for (int c = 0; c < 6; ++c) strains.col(c) = voigt_of_strain(boundaries[std::size_t(c)].strain);
  const Eigen::FullPivLU<Matrix6> lu(strains);
  return lu.isInvertible() ? std::optional(strains) : std::nullopt;
}

/// Sum over the bonds of D^T C D, D strain = the ends' relative displacement strain * branch.
Matrix6 voigt_bound(const BondNetwork& network, const std::vector<bool>& left_out, double cell_volume) {
  Eigen::Matrix<Extended, 6, 6> sum = Eigen::Matrix<Extended, 6, 6>::Zero();
  for (const Link& link : network.links) {
    if (!network.owns(link) || left_out[std::size_t(link.a)]) continue;
    const Vector3& d = link.branch;
    Eigen::Matrix<double, 3, 6> apart;
    apart << d.x(), 0, 0, 0, d.z() / 2, d.y() / 2,  //
        0, d.y(), 0, d.z() / 2, 0, d.x() / 2,       //
        0, 0, d.z(), d.y() / 2, d.x() / 2, 0;
    const Matrix3 c = constitutive_matrix(link.stiffness, bond_axis<double>(link)).topLeftCorner<3, 3>();
    sum += Matrix6(apart.transpose() * c * apart).cast<Extended>();
  }
  add_up(ranks_of(network), {sum.data(), 36});
  return sum.cast<double>() / cell_volume;
}

}  // namespace

Vector6 voigt_of_stress(const Matrix3& s) {
  Vector6 v;
  v << s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1);
  return v;
}

Vector6 voigt_of_strain(const Matrix3& e) {
  Vector6 v;
  v << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
  return v;
}

// The projections of the tensor onto the two isotropic ones, C_iijj / 9 = bulk modulus and
// (C_ijij - C_iijj / 3) / 10 = shear modulus.
IsotropicFit isotropic_fit(const Matrix6& c) {
  const double iijj = c.topLeftCorner<3, 3>().sum();
  const double ijij = c.topLeftCorner<3, 3>().trace() + 2 * c.bottomRightCorner<3, 3>().trace();
  const double bulk = iijj / 9, shear = (ijij - iijj / 3) / 10, lame = bulk - 2 * shear / 3;
  Matrix6 isotropic = Matrix6::Zero();
  isotropic.topLeftCorner<3, 3>().setConstant(lame);
  isotropic.diagonal().head<3>().array() += 2 * shear;
  isotropic.diagonal().tail<3>().setConstant(shear);
  return {9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear),
          weighted(c - isotropic).norm() / weighted(c).norm()};
}

std::optional<EffectiveStiffness> effective_stiffness(const Model& model, const BondNetwork& network,
                                                      const std::vector<Boundary>& boundaries,
                                                      const std::vector<bool>& left_out,
                                                      const StaticSolution& solution) {
  if (!model.cell || model.cell->periodic != std::array{true, true, true}) return std::nullopt;
  const auto strains = six_strains(boundaries, ranks_of(network));
  if (!strains) return std::nullopt;
  Matrix6 stresses;
  for (int c = 0; c < 6; ++c) stresses.col(c) = voigt_of_stress(solution.cases[std::size_t(c)].stress);
  const Matrix6 found = strains->transpose().fullPivLu().solve(stresses.transpose()).transpose();
  EffectiveStiffness effective;
  effective.volume = volume(*model.cell);
  effective.stiffness = 0.5 * (found + found.transpose());
  effective.asymmetry = weighted(found - found.transpose()).norm() / weighted(found).norm();
  effective.voigt = voigt_bound(network, left_out, effective.volume);
  effective.isotropic = isotropic_fit(effective.stiffness);
  return effective;
}

}  // namespace bondstatic
