// Fits of a few factors.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace bondstatic {

struct Fit {
  Eigen::VectorXd factors;
  double left = 0;  ///< |target - columns * factors|
};

inline Fit fitted(const Eigen::VectorXd& target, const Eigen::MatrixXd& columns) {
  Fit fit;
  fit.factors = columns.colPivHouseholderQr().solve(target);
  fit.left = (target - columns * fit.factors).norm();
  return fit;
}

/// Where a function of one variable with few valleys is lowest: the best of a grid, then golden section.
template <class Function>
double lowest_between(double from, double to, const Function& f) {
  constexpr int steps = 50, halvings = 50;
  const double width = (to - from) / steps;
  double best = from, least = f(from);
  for (int i = 1; i <= steps; ++i)
    if (const double value = f(from + i * width); value < least) least = value, best = from + i * width;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = std::max(from, best - width), high = std::min(to, best + width);
  for (int i = 0; i < halvings; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
  }
  return (low + high) / 2;
}

}  // namespace bondstatic
