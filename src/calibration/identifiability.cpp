#include "calibration/identifiability.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Units and tolerances of single residuals say nothing of what can be told apart.
MatrixXd rows_alike(const MatrixXd& jacobian) {
  const VectorXd length = jacobian.rowwise().norm();
  const double longest = length.size() ? length.maxCoeff() : 0;
  if (longest == 0) return jacobian;
  return length.cwiseMax(1e-6 * longest).cwiseInverse().asDiagonal() * jacobian;
}

// Reduced row echelon form with full pivoting: the same span, each row of as few parameters as may be.
void make_sparse(MatrixXd& rows) {
  std::vector<bool> used(std::size_t(rows.cols()));
  for (Index r = 0; r < rows.rows(); ++r) {
    Index pivot = -1, from = r;
    for (Index i = r; i < rows.rows(); ++i)
      for (Index j = 0; j < rows.cols(); ++j)
        if (!used[std::size_t(j)] && (pivot < 0 || std::abs(rows(i, j)) > std::abs(rows(from, pivot))))
          pivot = j, from = i;
    used[std::size_t(pivot)] = true;
    rows.row(r).swap(rows.row(from));
    rows.row(r) /= double(rows(r, pivot));
    for (Index i = 0; i < rows.rows(); ++i)
      if (i != r) rows.row(i) -= double(rows(i, pivot)) * rows.row(r);
  }
}

Index first_touched(const UnseenDirection& unseen) {
  Index j = 0;
  while (unseen.direction[j] == 0) ++j;
  return j;
}

}  // namespace

std::vector<UnseenDirection> unseen_directions(const MatrixXd& jacobian, const std::vector<Index>& columns) {
  std::vector<UnseenDirection> found;
  const MatrixXd alike = rows_alike(jacobian);
  const VectorXd length = alike.colwise().norm();
  std::vector<Index> seen;
  for (const Index j : columns) {
    if (length[j] > identified * length.maxCoeff())
      seen.push_back(j);
    else
      found.push_back({VectorXd::Unit(jacobian.cols(), j), true});
  }
  if (seen.empty()) return found;

  const VectorXd scale = length(seen);
  const Eigen::JacobiSVD<MatrixXd> svd(alike(Eigen::all, seen) * scale.cwiseInverse().asDiagonal(),
                                       Eigen::ComputeThinU | Eigen::ComputeFullV);
  const auto& sigma = svd.singularValues();
  const Index rank = (sigma.array() > identified * sigma[0]).count();
  MatrixXd null = svd.matrixV().rightCols(Index(seen.size()) - rank).transpose();
  if (null.rows() == 0) return found;
  make_sparse(null);
  for (Index r = 0; r < null.rows(); ++r) {
    UnseenDirection unseen{VectorXd::Zero(jacobian.cols())};
    // What is left of elimination where nothing should be.
    const VectorXd kept = (null.row(r).array().abs() > 1e-7).select(null.row(r).array(), 0.);
    unseen.direction(seen) = kept.cwiseQuotient(scale);
    unseen.direction.normalize();
    found.push_back(std::move(unseen));
  }
  std::sort(found.begin(), found.end(), [](const UnseenDirection& a, const UnseenDirection& b) {
    return first_touched(a) < first_touched(b);
  });
  return found;
}

}  // namespace bondstatic
