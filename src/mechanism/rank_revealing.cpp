#include "mechanism/rank_revealing.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace bondstatic {
namespace {

// Column pivoting costs memory traffic at every step, and nearly all large fronts have full rank: a few steps
// of inverse iteration on the triangle tell. Their estimate is above the smallest singular value, by a small
// factor where it matters, so that the margin to `tolerance` is wide.
bool surely_full_rank(const Eigen::MatrixXd& triangle, double tolerance) {
  constexpr Index small = 96;
  constexpr double margin = 1e4;
  const Index n = triangle.cols();
  if (triangle.rows() < n || n <= small) return false;
  const auto upper = triangle.triangularView<Eigen::Upper>();
  if (triangle.diagonal().cwiseAbs().minCoeff() <= margin * tolerance) return false;
  // Neither constant nor alternating, so that no motion of a regular lattice is missed.
  Eigen::VectorXd x(n);
  for (Index i = 0; i < n; ++i) x[i] = std::sin(double(i * i % 1009) + 0.5);
  double smallest = 1;
  for (int step = 0; step < 4; ++step) {
    x.normalize();
    const Eigen::VectorXd y = upper.transpose().solve(x);
    x = upper.solve(y);
    smallest = 1 / std::sqrt(x.norm());
    if (!(smallest > margin * tolerance)) return false;
  }
  return true;
}

}  // namespace

FrontFactor factorise_front(Eigen::MatrixXd matrix, Index eliminated, double tolerance) {
  const Index columns = matrix.cols(), bound = columns - eliminated;
  if (matrix.rows() > 0) {
    const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(matrix);
    matrix.triangularView<Eigen::StrictlyLower>().setZero();
    matrix.conservativeResize(std::min(matrix.rows(), columns), columns);
  }
  const Index top = std::min(matrix.rows(), eliminated), below = matrix.rows() - top;

  FrontFactor factor;
  factor.order.resize(std::size_t(eliminated));
  std::iota(factor.order.begin(), factor.order.end(), Index(0));
  Eigen::MatrixXd triangle = matrix.topLeftCorner(top, eliminated);
  Eigen::MatrixXd right = matrix.topRightCorner(top, bound);
  factor.rank = top;
  if (top > 0 && !surely_full_rank(triangle, tolerance)) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(triangle);
    if (bound > 0) right.applyOnTheLeft(qr.householderQ().adjoint());
    triangle = qr.matrixQR().triangularView<Eigen::Upper>();
    for (Index k = 0; k < eliminated; ++k) factor.order[std::size_t(k)] = qr.colsPermutation().indices()[k];
    for (factor.rank = 0; factor.rank < top; ++factor.rank)
      if (!(std::abs(triangle(factor.rank, factor.rank)) > tolerance)) break;
  }
  const Index rank = factor.rank;
  factor.solved = triangle.topLeftCorner(rank, rank);
  factor.free = -triangle.topRightCorner(rank, eliminated - rank);
  if (factor.free.size() > 0) factor.solved.triangularView<Eigen::Upper>().solveInPlace(factor.free);
  factor.boundary = right.topRows(rank);
  factor.rest.resize(top - rank + below, bound);
  factor.rest.topRows(top - rank) = right.bottomRows(top - rank);
  factor.rest.bottomRows(below) = matrix.bottomRightCorner(below, bound);
  return factor;
}

}  // namespace bondstatic
