// Tanh-sinh quadrature (Takahasi & Mori 1974): converges exponentially whatever the integrand does at the
// ends.
#pragma once

#include <cmath>
#include <numbers>

namespace bondstatic {

/// Integral over 0 < x < 1 of f(x, 1 - x). Both distances are exact to rounding, so that f can use the one
/// that vanishes. `f` returns anything that adds, scales and has .norm(): an Eigen vector integrates several
/// at once. The step is halved until two rules agree to 1e-8, which the next rule squares to below rounding.
template <class F>
auto integrate_unit_interval(F f) {
  using std::numbers::pi;
  constexpr double reach = 4.3;  // x = 1e-50: poles as near as 1e-30 to an end stay resolved
  constexpr int levels = 12;
  // x = 1 / (1 + exp(-pi sinh t)), dx/dt = pi cosh(t) x (1 - x)
  const auto term = [&](double t) {
    const double e = std::exp(-pi * std::sinh(t));
    const double x = 1 / (1 + e), complement = e / (1 + e);
    return (pi * std::cosh(t) * x * complement * f(x, complement)).eval();
  };
  double step = 0.25;
  auto sum = term(0);
  for (int k = 1; k * step <= reach; ++k) sum += term(k * step) + term(-k * step);
  bool agreed = false;
  for (int level = 0; level < levels; ++level) {
    auto between = term(0.5 * step);
    between += term(-0.5 * step);
    for (int k = 1; (k + 0.5) * step <= reach; ++k)
      between += term((k + 0.5) * step) + term(-(k + 0.5) * step);
    const double change = (between - sum).norm() / (between + sum).norm();
    sum += between;
    step *= 0.5;
    if (agreed) break;
    agreed = change < 1e-8;
  }
  return (step * sum).eval();
}

}  // namespace bondstatic
