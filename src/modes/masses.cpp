#include "modes/masses.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

BodyMasses body_masses(const Model& model) {
  BodyMasses masses;
  masses.mass.reserve(model.particles.size());
  masses.inertia.reserve(model.particles.size());
  for (const Particle& particle : model.particles) {
    masses.mass.push_back(mass(particle));
    masses.inertia.push_back(moment_of_inertia(particle));
  }
  return masses;
}

Eigen::VectorXd mass_roots(const BodyMasses& masses, const FreeDofs& dofs) {
  Eigen::VectorXd roots(dofs.unknowns());
  Index unknown = 0;
  for (std::size_t p = 0; p < dofs.free.size(); ++p)
    for (int i = 0; i < 6; ++i) {
      if (!dofs.is_free(Index(p), i)) continue;
      const double value = i < 3 ? masses.mass[p] : masses.inertia[p];
      if (!(value > 0) || !std::isfinite(value))
        throw Error(ExitCode::invalid_input,
                    fmt::format("the {} of body {} (counted from 0) is {}: must be positive\n    cure: give "
                                "every free particle a density",
                                i < 3 ? "mass" : "moment of inertia", p, value));
      roots[unknown++] = std::sqrt(value);
    }
  return roots;
}

void motion_of(const double* y, const Eigen::VectorXd& roots, const FreeDofs& dofs,
               BodyVectors<double>& motion) {
  Index unknown = 0;
  for (std::size_t p = 0; p < motion.size(); ++p)
    for (int i = 0; i < 6; ++i) {
      const bool free = dofs.is_free(Index(p), i);
      motion[p][i] = free ? y[unknown] / roots[unknown] : 0;
      unknown += free;
    }
}

double twice_energy(const BondNetwork& network, const BodyVectors<double>& motion) {
  double sum = 0;
  for (const Link& link : network.links) {
    const Vector6 delta =
        relative_motion<double>(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
    sum += delta.dot(resultants<double>(link.stiffness, bond_axis<double>(link), delta));
  }
  return sum;
}

}  // namespace bondstatic
