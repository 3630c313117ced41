// Small bonded models for the tests of mechanisms, and a brute-force count of their free motions.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <bit>
#include <random>
#include <string>
#include <vector>

#include "bondstatic/mechanism.hpp"

namespace bondstatic::test {

inline constexpr SectionStiffness beam{1, 1, 1, 1, 0};
inline constexpr SectionStiffness contact{1, 1, 0, 0, 0};
inline constexpr SectionStiffness frictionless{1, 0, 0, 0, 0};

/// A model without laws: links and masks are given at once.
struct Net {
  Model model;
  BondNetwork network;
  std::vector<std::uint8_t> free;

  Index particle(const Vector3& position, double radius = 0.5) {
    const Index p = Index(model.particles.size());
    model.particles.push_back({.id = p + 1, .position = position, .radius = radius});
    free.push_back(0x3f);
    network.bodies = p + 1;
    return p;
  }
  void bond(Index a, Index b, const SectionStiffness& stiffness = beam, double fraction = 0.5) {
    network.links.push_back({a, b, at(b) - at(a), fraction, stiffness});
  }
  /// `dofs` as letters: "xyz" and "uvw" for rx, ry, rz.
  void hold(Index p, const std::string& dofs = "xyzuvw") {
    for (const char c : dofs) free[std::size_t(p)] &= std::uint8_t(~(1 << std::string("xyzuvw").find(c)));
  }
  const Vector3& at(Index p) const { return model.particles[std::size_t(p)].position; }
  Index count() const { return network.bodies; }

  FreeDofs dofs() const {
    FreeDofs numbered{.free = free, .first = {0}};
    for (const std::uint8_t mask : free)
      numbered.first.push_back(numbered.first.back() + Index(std::popcount(mask)));
    return numbered;
  }
  std::vector<Mechanism> mechanisms(const std::vector<bool>& left_out = {}) const {
    return find_mechanisms(model, network, dofs(), left_out);
  }
};

/// A bar of beam bonds along the points.
inline std::vector<Index> chain(Net& net, const Vector3& from, const Vector3& step, Index count) {
  std::vector<Index> particles;
  for (Index i = 0; i < count; ++i) {
    particles.push_back(net.particle(from + double(i) * step, step.norm() / 2));
    if (i > 0) net.bond(particles[std::size_t(i) - 1], particles[std::size_t(i)]);
  }
  return particles;
}

inline Index motions_in_all(const std::vector<Mechanism>& mechanisms) {
  Index count = 0;
  for (const Mechanism& m : mechanisms) count += Index(m.motions.size());
  return count;
}

/// Null space of the constraints of all particles together, one column a motion (x, y, z, length * rotation):
/// C with all its non-zero stiffnesses set to one, by its eigenvectors, and an SVD of the whole matrix.
inline Eigen::MatrixXd brute_force_motions(const Net& net, const std::vector<bool>& held, double& gap) {
  double length = 0;
  for (const Link& link : net.network.links) length = std::max(length, link.branch.norm());
  if (length == 0) length = 1;
  const Index n = net.count();
  std::vector<Eigen::RowVectorXd> rows;
  for (const Link& link : net.network.links) {
    if (!held[std::size_t(link.a)]) continue;
    SectionStiffness unit = link.stiffness;
    for (double* k : {&unit.kn, &unit.ks, &unit.kt, &unit.kb}) *k = *k > 0 ? 1 : 0;
    const Eigen::SelfAdjointEigenSolver<Matrix6> c(constitutive_matrix(unit, bond_axis<double>(link)));
    Matrix6x12 b = relative_motion_matrix(link);
    b.bottomRows(3) *= length;
    b.middleCols(3, 3) /= length;
    b.middleCols(9, 3) /= length;
    for (int i = 0; i < 6; ++i) {
      if (c.eigenvalues()[i] < 0.5) continue;
      const Eigen::Matrix<double, 1, 12> form = c.eigenvectors().col(i).transpose() * b;
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(6 * n);
      row.segment(6 * link.a, 6) += form.head(6);
      row.segment(6 * link.b, 6) += form.tail(6);
      rows.push_back(row);
    }
  }
  for (Index p = 0; p < n; ++p)
    for (int d = 0; d < 6; ++d)
      if (!((net.free[std::size_t(p)] >> d) & 1) || !held[std::size_t(p)])
        rows.push_back(Eigen::RowVectorXd::Unit(6 * n, 6 * p + d));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(std::max(Index(rows.size()), 6 * n), 6 * n);
  for (std::size_t r = 0; r < rows.size(); ++r) matrix.row(Index(r)) = rows[r];
  // Jacobi, not divide and conquer: the latter loses its way in such degenerate spectra (Eigen 3.4).
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinV);
  const auto& s = svd.singularValues();
  Index rank = 0;
  while (rank < s.size() && s[rank] > 1e-10 * s[0]) ++rank;
  gap = rank == 0 ? 1 : s[rank - 1] / s[0];
  return svd.matrixV().rightCols(6 * n - rank);
}

}  // namespace bondstatic::test
