// Networks with masses, small enough for a dense solve of K x = w^2 M x.
#pragma once

#include <Eigen/Eigenvalues>
#include <memory>

#include "bondstatic/modes.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

/// k of a link: column i are the forces its two bodies need where degree of freedom i moves by one.
template <class Scalar>
Eigen::Matrix<Scalar, 12, 12> end_forces(const Link& link) {
  Eigen::Matrix<Scalar, 12, 12> k;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Matrix<Scalar, 12, 1> unit = Eigen::Matrix<Scalar, 12, 1>::Unit(i);
    const Vector6T<Scalar> delta =
        relative_motion<Scalar>(link, unit.template head<6>(), unit.template tail<6>());
    const Vector6T<Scalar> q = resultants<Scalar>(link.stiffness, bond_axis<Scalar>(link), delta);
    k.col(i) << -force_on_a<Scalar>(link, q), -force_on_b<Scalar>(link, q);
  }
  return k;
}

struct VibrationProblem {
  BondNetwork network;
  FreeDofs dofs;
  BodyMasses masses;

  VibrationProblem() = default;
  /// Particles without density get one, each another.
  VibrationProblem(Model model, std::vector<std::uint8_t> free);

  /// Diagonal of M, by unknown.
  Eigen::VectorXd mass_diagonal() const;

  /// M^-1/2 K M^-1/2 of the unknowns, for the links of `links`.
  template <class Scalar>
  Eigen::Matrix<Scalar, -1, -1> scaled_stiffness(const BondNetwork& links) const {
    Eigen::Matrix<Scalar, -1, -1> k = Eigen::Matrix<Scalar, -1, -1>::Zero(dofs.unknowns(), dofs.unknowns());
    for (const Link& link : links.links) {
      const auto local = end_forces<Scalar>(link);
      const std::vector<Index> unknown = unknowns_of(link);
      for (int c = 0; c < 12; ++c)
        for (int r = 0; r < 12; ++r)
          if (unknown[std::size_t(r)] >= 0 && unknown[std::size_t(c)] >= 0)
            k(unknown[std::size_t(r)], unknown[std::size_t(c)]) += local(r, c);
    }
    const Eigen::Matrix<Scalar, -1, 1> root =
        mass_diagonal().template cast<Scalar>().cwiseSqrt().cwiseInverse();
    const Eigen::Matrix<Scalar, -1, -1> scaled = root.asDiagonal() * k * root.asDiagonal();
    return (scaled + scaled.transpose()) / 2;
  }

  /// All of them, ascending, by a dense solve in that precision.
  template <class Scalar>
  Eigen::VectorXd dense_frequencies() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Scalar, -1, -1>> solver(
        scaled_stiffness<Scalar>(network), Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseSqrt().template cast<double>();
  }

  std::vector<Mode> lowest(Index count, const std::string& solver = "auto") const;

 private:
  std::vector<Index> unknowns_of(const Link& link) const;  ///< of its 12 degrees of freedom, -1 where held
};

/// Fixed-free chain of `bodies` springs of stiffness k along x, with as many masses m.
VibrationProblem spring_chain(Index bodies, double k, double m);

}  // namespace bondstatic::test
