#include "calibration/ceres/damping.hpp"

#include <Eigen/SVD>

#include "calibration/identifiability.hpp"

namespace bondstatic {

Damping choose_damping(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals, double longest) {
  const Eigen::VectorXd length = jacobian.colwise().norm();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian * length.cwiseInverse().asDiagonal(),
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::ArrayXd sigma = svd.singularValues();
  const Eigen::ArrayXd along = svd.matrixU().transpose() * residuals;
  const auto longest_of = [&](const Eigen::ArrayXd& step) {
    return (svd.matrixV() * step.matrix()).cwiseQuotient(length).cwiseAbs().maxCoeff();
  };
  const auto longest_step = [&](double radius) {
    return longest_of(along * sigma / (sigma.square() + 1 / radius));
  };

  // Weak enough to leave Newton's rate in all directions that the residuals tell apart. Along the others,
  // where there are any, only rounding pulls, and it must not pull far.
  const auto seen = (sigma > identified * sigma[0]).eval();
  const double weakest = seen.select(sigma, sigma[0]).minCoeff();
  Damping damping;
  damping.radius = (seen.all() ? 1e12 : 1e6) / (weakest * weakest);
  damping.undamped_length = longest_of(seen.select(along / sigma, 0.));
  const double all = residuals.squaredNorm();
  if (all > 0) damping.gain = seen.select(along, 0.).square().sum() / all;
  while (longest_step(damping.radius) > longest && damping.radius > 1e-200) {
    damping.radius /= 2;
    damping.shortens = true;
  }
  return damping;
}

}  // namespace bondstatic
