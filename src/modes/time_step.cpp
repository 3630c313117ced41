#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "modes/highest.hpp"

namespace bondstatic {

namespace {

// The iteration comes from above, and quadratically: a handful of rounds, however strong the damping. The
// first ones need no sharp eigenvalue: any motion gives a step that is too long, never one too short.
constexpr int most_rounds = 30;
constexpr double rough = 1e-4, sharp = 1e-10;

SectionStiffness sum(double k_share, const SectionStiffness& k, double d_share, const SectionStiffness& d) {
  return {k_share * k.kn + d_share * d.kn, k_share * k.ks + d_share * d.ks, k_share * k.kt + d_share * d.kt,
          k_share * k.kb + d_share * d.kb, k_share * k.coupling + d_share * d.coupling};
}

// Where the scalar equation of a motion x with x^T M x = 1 holds: 4 = 2 dt d + dt^2 w.
double step_of(double d, double w) {
  return 4 / (d + std::sqrt(d * d + 4 * w));
}

}  // namespace

double critical_time_step(const BondNetwork& stiffness, const BondNetwork* dashpots, const FreeDofs& dofs,
                          const BodyMasses& masses, int threads) {
  if (dashpots && dashpots->links.size() != stiffness.links.size())
    throw std::invalid_argument("critical_time_step: dashpots must have the links of the stiffness");
  if (dofs.unknowns() == 0) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd roots = mass_roots(masses, dofs);
  const Incidence incidence = link_incidence(stiffness);
  const auto highest = [&](const BondNetwork& network, double tolerance) {
    return highest_pair(network, incidence, dofs, roots, threads, tolerance);
  };
  if (!dashpots) {
    const DominantPair pair = highest(stiffness, sharp);
    return step_of(0, pair.value + pair.residual);
  }
  double step = step_of(0, highest(stiffness, rough).value);
  if (std::isinf(step)) step = step_of(highest(*dashpots, rough).value, 0);
  if (std::isinf(step)) return step;

  BondNetwork combined = stiffness;
  BodyVectors<double> motion(std::size_t(stiffness.bodies));
  double tolerance = rough;
  for (int round = 1;; ++round) {
    for (std::size_t k = 0; k < combined.links.size(); ++k)
      combined.links[k].stiffness =
          sum(step * step, stiffness.links[k].stiffness, 2 * step, dashpots->links[k].stiffness);
    const DominantPair pair = highest(combined, tolerance);
    motion_of(pair.vector.data(), roots, dofs, motion);
    const double next =
        std::min(step, step_of(twice_energy(*dashpots, motion), twice_energy(stiffness, motion)));
    const bool settled = next >= step * (1 - tolerance);
    // A step c times shorter makes the eigenvalue shorter by c at least: what is left over is taken off.
    if ((settled && tolerance == sharp) || round == most_rounds)
      return std::min(next, step * std::min(1.0, 4 / (pair.value + pair.residual)));
    if (settled) tolerance = sharp;
    step = next;
  }
}

}  // namespace bondstatic
