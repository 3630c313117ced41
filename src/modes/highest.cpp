#include "modes/highest.hpp"

#include <cmath>

namespace bondstatic {

namespace {

// B^T C B u at one body. Each link is evaluated at both its ends: cheaper than to store what it carries.
Vector6 force_at(const BondNetwork& network, const Incidence& incidence, const BodyVectors<double>& motion,
                 Index body) {
  Vector6 sum = Vector6::Zero();
  for (const Index k : incidence.of(body)) {
    const Link& link = network.links[std::size_t(k)];
    const auto delta =
        relative_motion<double>(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
    const auto q = resultants<double>(link.stiffness, bond_axis<double>(link), delta);
    sum -= link.a == body ? force_on_a<double>(link, q) : force_on_b<double>(link, q);
  }
  return sum;
}

}  // namespace

DominantPair highest_pair(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                          const Eigen::VectorXd& roots, int threads, double tolerance) {
  BodyVectors<double> motion(std::size_t(network.bodies));
  const Operator stiffness = [&](const double* x, double* y) {
    motion_of(x, roots, dofs, motion);
#pragma omp parallel for schedule(static) \
    num_threads(threads) if (threads > 1 && network.bodies > worth_threads)
    for (Index p = 0; p < network.bodies; ++p) {
      Index unknown = dofs.first[std::size_t(p)];
      if (unknown == dofs.first[std::size_t(p) + 1]) continue;
      const Vector6 force = force_at(network, incidence, motion, p);
      for (int i = 0; i < 6; ++i)
        if (dofs.is_free(p, i)) {
          y[unknown] = force[i] / roots[unknown];
          ++unknown;
        }
    }
  };
  return dominant_eigenpair(roots.size(), stiffness, tolerance);
}

double highest_frequency(const BondNetwork& network, const FreeDofs& dofs, const BodyMasses& masses,
                         int threads, double tolerance) {
  if (dofs.unknowns() == 0) return 0;
  const DominantPair pair =
      highest_pair(network, link_incidence(network), dofs, mass_roots(masses, dofs), threads, tolerance);
  return std::sqrt(pair.value + pair.residual);
}

}  // namespace bondstatic
