#include <cmath>

#include "bondstatic/dynamics.hpp"

namespace bondstatic {

namespace {

/// m1 m2 / (m1 + m2); the other's own where one is held (infinite), nothing where both are.
double reduced(double m1, double m2) {
  if (std::isinf(m1)) return std::isinf(m2) ? 0 : m2;
  return std::isinf(m2) ? m1 : m1 * m2 / (m1 + m2);
}

constexpr double held = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<SectionStiffness> dashpots(const Model& model, std::span<const BondProperties> properties,
                                       std::span<const std::uint8_t> free, const BondDamping& damping) {
  std::vector<SectionStiffness> coefficients(model.bonds.size());
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const auto a = std::size_t(model.bonds[k].a), b = std::size_t(model.bonds[k].b);
    const auto mass_of = [&](std::size_t p) { return free[p] & 0x07 ? mass(model.particles[p]) : held; };
    const auto inertia_of = [&](std::size_t p) {
      return free[p] & 0x38 ? moment_of_inertia(model.particles[p]) : held;
    };
    const double m = reduced(mass_of(a), mass_of(b)), i = reduced(inertia_of(a), inertia_of(b));
    const SectionStiffness& c = properties[k].stiffness;
    const double forces = 2 * damping.paper * std::sqrt(c.kn * m);       // Eq. 9
    const double moments = 2 * damping.paper * std::sqrt(2 * c.kt * i);  // Eq. 10
    coefficients[k].kn = forces + 2 * damping.normal * std::sqrt(c.kn * m);
    coefficients[k].ks = forces + 2 * damping.shear * std::sqrt(c.ks * m);
    coefficients[k].kt = moments + 2 * damping.twisting * std::sqrt(c.kt * i);
    coefficients[k].kb = moments + 2 * damping.bending * std::sqrt(c.kb * i);
    if (!properties[k].moments_fed_back) coefficients[k].kt = coefficients[k].kb = 0;
  }
  return coefficients;
}

}  // namespace bondstatic
