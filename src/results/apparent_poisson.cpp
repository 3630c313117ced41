#include "results/apparent_poisson.hpp"

#include "model/middle_third.hpp"
#include "results/lateral_strain.hpp"

namespace bondstatic {

namespace {

std::vector<Index> middle_of(const Model& model, const Output& output) {
  return output.middle.empty() ? middle_third(model, output.base, output.at, output.axis) : output.middle;
}

struct Strains {
  double axial = 0, lateral = 0;
  double height = 0;                   ///< of `at` over `base`, along the axis
  std::vector<Vector3> lateral_slope;  ///< by particle of the middle
};

Strains strains(const Output& output, const std::vector<SpecimenParticle>& base,
                const std::vector<SpecimenParticle>& at, const std::vector<SpecimenParticle>& middle) {
  const Vector3 e = output.axis.normalized();
  const Platen below = platen(base, e), above = platen(at, e);
  Strains found;
  found.height = above.position - below.position;
  found.axial = (above.displacement - below.displacement) / found.height;
  found.lateral_slope = lateral_strain_weights(output, middle);
  // The weights sum up to zero but for rounding: what all have in common is taken off first.
  Vector3 common = Vector3::Zero();
  double count = 0;
  for (const SpecimenParticle& particle : middle)
    if (!particle.left_out()) common += particle.displacement, ++count;
  common /= count;
  for (std::size_t p = 0; p < middle.size(); ++p)
    if (!middle[p].left_out()) found.lateral += found.lateral_slope[p].dot(middle[p].displacement - common);
  return found;
}

}  // namespace

double apparent_poisson(const Output& output, const std::vector<SpecimenParticle>& base,
                        const std::vector<SpecimenParticle>& at,
                        const std::vector<SpecimenParticle>& middle) {
  const Strains found = strains(output, base, at, middle);
  return -found.lateral / found.axial;
}

double apparent_poisson(const Model& model, const State& state, const Output& output) {
  return apparent_poisson(output, specimen_particles(model, state, output.base),
                          specimen_particles(model, state, output.at),
                          specimen_particles(model, state, middle_of(model, output)));
}

Functional apparent_poisson_slope(const Model& model, const State& state, const Output& output) {
  const std::vector<Index> middle = middle_of(model, output);
  const Strains found =
      strains(output, specimen_particles(model, state, output.base),
              specimen_particles(model, state, output.at), specimen_particles(model, state, middle));
  const Vector3 e = output.axis.normalized();
  const double by_apart = found.lateral / (found.axial * found.axial * found.height);
  Functional functional;
  add_platen(functional, state, output.base, e, -by_apart, 0);
  add_platen(functional, state, output.at, e, by_apart, 0);
  for (std::size_t p = 0; p < middle.size(); ++p) {
    Vector6 slope = Vector6::Zero();
    slope.head<3>() = -found.lateral_slope[p] / found.axial;
    if (!slope.isZero(0)) functional.displacement.emplace_back(middle[p], slope);
  }
  return functional;
}

}  // namespace bondstatic
