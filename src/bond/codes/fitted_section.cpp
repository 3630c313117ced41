#include <cmath>

#include "bond/codes/codes.hpp"

namespace bondstatic {

FittedSection fitted_section(const BondSite& site, const BondProperties& wanted, double moment_factor) {
  const SectionStiffness& c = wanted.stiffness;
  double squared;
  if (c.kb > 0) {
    squared = 4 * c.kb / (moment_factor * c.kn);
  } else if (c.kt > 0 && c.ks > 0) {
    squared = 2 * c.kt / (moment_factor * c.ks);
  } else {
    const double radius = wanted.radius > 0 ? wanted.radius : smaller_radius(site);
    squared = radius * radius;
  }
  const double area = std::numbers::pi * squared;
  return {c.kn / area, c.ks / area, std::sqrt(squared)};
}

}  // namespace bondstatic
