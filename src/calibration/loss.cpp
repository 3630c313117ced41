#include <cmath>

#include "calibration/least_squares.hpp"

namespace bondstatic {

double loss_width(Loss loss) {
  return loss == Loss::huber ? 1.345 : 2.385;
}

double rho(Loss loss, double s) {
  const double a = loss_width(loss);
  if (loss == Loss::huber && s > a * a) return 2 * a * std::sqrt(s) - a * a;
  if (loss == Loss::cauchy) return a * a * std::log1p(s / (a * a));
  return s;
}

double rho_slope(Loss loss, double s) {
  const double a = loss_width(loss);
  if (loss == Loss::huber && s > a * a) return a / std::sqrt(s);
  if (loss == Loss::cauchy) return 1 / (1 + s / (a * a));
  return 1;
}

double cost(Loss loss, const Eigen::VectorXd& residuals) {
  double sum = 0;
  for (const double r : residuals) sum += rho(loss, r * r);
  return sum / 2;
}

Eigen::VectorXd weights(Loss loss, const Eigen::VectorXd& residuals) {
  return residuals.unaryExpr([loss](double r) { return rho_slope(loss, r * r); });
}

}  // namespace bondstatic
