#include "calibration/intervals.hpp"

#include <Eigen/SVD>
#include <limits>

#include "calibration/ceres_module.hpp"

namespace bondstatic {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double normal_quantile = 1.959963984540054;  // of 97.5 %

// (S^T S)^+ of that rank, by the SVD of S with columns of length 1, whatever their units.
MatrixXd pseudo_inverse_of_square(const MatrixXd& s, Index rank) {
  const VectorXd length = s.colwise().norm();
  const Eigen::JacobiSVD<MatrixXd> svd(s * length.cwiseInverse().asDiagonal(),
                                       Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd inverse = svd.singularValues().head(rank).cwiseInverse();
  const MatrixXd root =
      length.cwiseInverse().asDiagonal() * svd.matrixV().leftCols(rank) * inverse.asDiagonal();
  return root * root.transpose();
}

double quantile_times_size(const Minimum& minimum, const VectorXd& weight, Index fitted, bool known_errors) {
  if (known_errors) return normal_quantile;
  const Index freedom = minimum.residuals.size() - fitted;
  if (freedom <= 0) return nan;
  const double squares = weight.dot(minimum.residuals.cwiseAbs2());
  return ceres_module().student_t(0.95, double(freedom)) * std::sqrt(squares / double(freedom));
}

}  // namespace

Intervals intervals(const Minimum& minimum, Loss loss, const std::vector<Index>& settled,
                    const std::vector<Index>& loose, Index unseen, bool known_errors) {
  const Index n = minimum.x.size();
  Intervals found{VectorXd::Constant(n, nan), MatrixXd::Constant(n, n, nan)};
  if (settled.empty()) return found;
  const VectorXd weight = weights(loss, minimum.residuals);
  std::vector<Index> all = settled;
  all.insert(all.end(), loose.begin(), loose.end());
  const Index fitted = Index(all.size()) - unseen;
  const MatrixXd covariance =
      pseudo_inverse_of_square(weight.cwiseSqrt().asDiagonal() * minimum.jacobian(Eigen::all, all), fitted);
  const double factor = quantile_times_size(minimum, weight, fitted, known_errors);
  for (Index i = 0; i < Index(settled.size()); ++i) {
    found.half_width[settled[std::size_t(i)]] = factor * std::sqrt(covariance(i, i));
    for (Index j = 0; j < Index(settled.size()); ++j)
      found.correlation(settled[std::size_t(i)], settled[std::size_t(j)]) =
          i == j ? 1 : covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
  }
  return found;
}

}  // namespace bondstatic
