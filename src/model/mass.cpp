#include <numbers>

#include "bondstatic/model.hpp"

namespace bondstatic {

double mass(const Particle& particle) {
  const double r = particle.radius;
  return 4.0 / 3 * std::numbers::pi * r * r * r * particle.density;
}

double moment_of_inertia(const Particle& particle) {
  return 0.4 * mass(particle) * particle.radius * particle.radius;
}

}  // namespace bondstatic
