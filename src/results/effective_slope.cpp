#include "results/effective_slope.hpp"

#include <Eigen/LU>

namespace bondstatic {

namespace {

/// W with W : stress = by_stress . voigt_of_stress(stress) for symmetric stresses.
Matrix3 weight_of_stress(const Vector6& by_stress) {
  Matrix3 w;
  w << by_stress[0], by_stress[5] / 2, by_stress[4] / 2,  //
      by_stress[5] / 2, by_stress[1], by_stress[3] / 2,   //
      by_stress[4] / 2, by_stress[3] / 2, by_stress[2];
  return w;
}

}  // namespace

// The stiffness is the symmetric part of stresses * strains^-1, both with a load case as a column.
Functionals effective_slope(const Matrix6& by_stiffness, const StaticSolution& solution) {
  Matrix6 strains;
  for (int c = 0; c < 6; ++c) strains.col(c) = voigt_of_strain(solution.cases[std::size_t(c)].strain);
  const Matrix6 symmetric = 0.5 * (by_stiffness + by_stiffness.transpose());
  const Matrix6 by_stresses = strains.fullPivLu().solve(symmetric).transpose();
  Functionals functionals;
  for (int c = 0; c < 6; ++c) {
    functionals.emplace_back().load_case = c;
    functionals.back().stress = weight_of_stress(by_stresses.col(c));
  }
  return functionals;
}

}  // namespace bondstatic
