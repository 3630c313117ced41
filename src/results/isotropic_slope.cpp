#include "results/isotropic_slope.hpp"

namespace bondstatic {

namespace {

/// Both moduli are linear in the stiffness: these are what isotropic_fit() multiplies it with.
struct Moduli {
  double bulk = 0, shear = 0;
  Matrix6 bulk_slope = Matrix6::Zero(), shear_slope = Matrix6::Zero();
};

Moduli moduli_of(const Matrix6& stiffness) {
  Moduli m;
  m.bulk_slope.topLeftCorner<3, 3>().setConstant(1.0 / 9);
  m.shear_slope.diagonal() << 0.1, 0.1, 0.1, 0.2, 0.2, 0.2;
  m.shear_slope.topLeftCorner<3, 3>().array() -= 1.0 / 30;
  m.bulk = stiffness.cwiseProduct(m.bulk_slope).sum();
  m.shear = stiffness.cwiseProduct(m.shear_slope).sum();
  return m;
}

/// C times the squares of the weights that make the norm of a stiffness that of the tensor: half the
/// derivative of that norm's square.
Matrix6 metric(const Matrix6& c) {
  Vector6 squares;
  squares << 1, 1, 1, 2, 2, 2;
  return squares.asDiagonal() * c * squares.asDiagonal();
}

double norm(const Matrix6& c) {
  return std::sqrt(c.cwiseProduct(metric(c)).sum());
}

}  // namespace

Matrix6 isotropic_young_slope(const Matrix6& stiffness) {
  const Moduli m = moduli_of(stiffness);
  const double k = m.bulk, g = m.shear, sum = 3 * k + g;
  return 9 * g * g / (sum * sum) * m.bulk_slope + 27 * k * k / (sum * sum) * m.shear_slope;
}

Matrix6 isotropic_poisson_slope(const Matrix6& stiffness) {
  const Moduli m = moduli_of(stiffness);
  const double k = m.bulk, g = m.shear, sum = 6 * k + 2 * g;
  return 18 / (sum * sum) * (g * m.bulk_slope - k * m.shear_slope);
}

std::optional<Matrix6> isotropic_misfit_slope(const Matrix6& stiffness) {
  const Moduli m = moduli_of(stiffness);
  Matrix6 apart = stiffness;
  apart.topLeftCorner<3, 3>().array() -= m.bulk - 2 * m.shear / 3;
  apart.diagonal().head<3>().array() -= 2 * m.shear;
  apart.diagonal().tail<3>().array() -= m.shear;
  const double misfit = norm(apart), whole = norm(stiffness);
  if (!(misfit > 1e-8 * whole)) return std::nullopt;
  // What is apart is perpendicular to all isotropic stiffnesses: how the nearest one changes does not count.
  return metric(apart) / (misfit * whole) - misfit / (whole * whole * whole) * metric(stiffness);
}

}  // namespace bondstatic
