#include "results/apparent_young.hpp"

#include <cmath>

namespace bondstatic {

namespace {

LateralBox box_of_all(const Model& model, const State& state, const Output& output) {
  return lateral_box(model, state, Index(model.particles.size()), output.axis);
}

}  // namespace

double apparent_young(const Output& output, const std::vector<SpecimenParticle>& base,
                      const std::vector<SpecimenParticle>& at, const LateralBox& box) {
  const Vector3 e = output.axis.normalized();
  const Platen below = platen(base, e), above = platen(at, e);
  const double height = std::abs(above.position - below.position);
  // A specimen in tension pulls its base towards the top; the support pulls back.
  return -below.reaction * height / (box.area() * (above.displacement - below.displacement));
}

double apparent_young(const Model& model, const State& state, const Output& output) {
  return apparent_young(output, specimen_particles(model, state, output.base),
                        specimen_particles(model, state, output.at), box_of_all(model, state, output));
}

Functional apparent_young_slope(const Model& model, const State& state, const Output& output) {
  const Vector3 e = output.axis.normalized();
  const Platen below = platen(specimen_particles(model, state, output.base), e),
               above = platen(specimen_particles(model, state, output.at), e);
  const double apart = above.displacement - below.displacement;
  const double by_reaction =
      -std::abs(above.position - below.position) / (box_of_all(model, state, output).area() * apart);
  const double by_apart = -by_reaction * below.reaction / apart;
  Functional functional;
  add_platen(functional, state, output.base, e, -by_apart, by_reaction);
  add_platen(functional, state, output.at, e, by_apart, 0);
  return functional;
}

}  // namespace bondstatic
