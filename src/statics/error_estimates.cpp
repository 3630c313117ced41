#include "statics/error_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "statics/residual.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

// Deterministic signs: the estimate below must not depend on a random state.
double sign_of(std::uint64_t n) {
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9u;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebu;
  return (n >> 31) & 1 ? 1 : -1;
}

}  // namespace

BodyVectors<double> rounding_forces(const BondNetwork& network, const Incidence& incidence,
                                    const BodyVectors<double>& motion, const Matrix3& strain) {
  BodyVectors<double> q(network.links.size());
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Link& link = network.links[k];
    Vector6 e = motion_magnitude(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)], strain);
    for (int i = 0; i < 6; ++i) e[i] *= 4 * extended_rounding * sign_of(6 * k + std::uint64_t(i));
    q[k] = resultants<double>(link.stiffness, bond_axis<double>(link), e);
  }
  return gather_forces<double>(network, incidence, q, 1);
}

double backward_error(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                      const Boundary& boundary, const BodyVectors<double>& motion, double size, int threads) {
  const auto r = residual(network, boundary, converted<Extended>(motion, threads), threads);
  const auto magnitude = force_magnitudes(network, incidence, motion, threads, boundary.strain);
  constexpr double doubtful = 0x1p-50, noise = 1000 * 0x1p-53;
  Vector6 everywhere = Vector6::Constant(size);
  everywhere.tail<3>() /= network.rotation_length;
  BodyVectors<double> largest;  // seldom needed
  double worst = 0;
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
    if (Index(p) >= network.own()) return;
    double scale = magnitude[p][i] + std::abs(boundary.load[p][i]);
    if (!(scale > 0)) return;
    const double left = std::abs(to_double(r[p][i]));
    if (left > doubtful * scale) {
      if (largest.empty()) largest.assign(motion.size(), everywhere);
      const double possible = force_magnitude(network, incidence, largest, Index(p), boundary.strain)[i];
      if (scale <= noise * possible) scale += possible;
    }
    worst = std::max(worst, left / scale);
  });
  return worst;
}

}  // namespace bondstatic
