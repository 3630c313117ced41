#include "multigrid/strength.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace bondstatic::multigrid {

namespace {

double blend(double weakest, double mean) {
  constexpr double little = 1e-4;
  return std::max(0.0, weakest) + little * mean;
}

// The smallest pivot stands for the smallest eigenvalue: it is never below it, and a tenth of the work.
template <class Scalar>
double weakest_and_mean(const RigidLink<Scalar>& link) {
  const double length = (arm_a(link) - arm_b(link)).norm();
  Matrix6 c = stiffness_of(link);
  c.rightCols<3>() /= length;
  c.bottomRows<3>() /= length;
  const Eigen::LDLT<Matrix6> pivoted(c);
  return blend(pivoted.vectorD().minCoeff(), c.trace() / 6);
}

}  // namespace

double strength(const Link& link) {
  const SectionStiffness& c = link.stiffness;
  const double square = link.branch.squaredNorm(), kt = c.kt / square, kb = c.kb / square;
  return blend(std::min({c.kn, c.ks, kt, kb}), (c.kn + 2 * c.ks + kt + 2 * kb) / 6);
}

double strength(const RigidLink<float>& link) {
  return weakest_and_mean(link);
}
double strength(const RigidLink<double>& link) {
  return weakest_and_mean(link);
}

}  // namespace bondstatic::multigrid
