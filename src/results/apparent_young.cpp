#include "results/apparent_young.hpp"

#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

bool left_out(const State& state, Index particle) {
  return std::isnan(state.displacement[std::size_t(particle)][0]);
}

/// Means of the position and the displacement, sum of the reactions.
PlatenParticle platen(const std::vector<PlatenParticle>& particles) {
  PlatenParticle sum;
  double count = 0;
  for (const PlatenParticle& particle : particles) {
    if (std::isnan(particle.displacement)) continue;
    sum.position += particle.position;
    sum.displacement += particle.displacement;
    sum.reaction += particle.reaction;
    ++count;
  }
  return {sum.position / count, sum.displacement / count, sum.reaction};
}

}  // namespace

PlatenParticle platen_particle(const Model& model, const State& state, Index particle, const Vector3& axis) {
  if (left_out(state, particle)) return {not_given, not_given, not_given};
  const Vector3 e = axis.normalized();
  const auto p = std::size_t(particle);
  return {e.dot(model.particles[p].position), e.dot(state.displacement[p].head<3>()),
          e.dot(state.reaction[p].head<3>())};
}

void LateralBox::include(const LateralBox& other) {
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

LateralBox lateral_box(const Model& model, const State& state, Index count, const Vector3& axis) {
  const Vector3 e = axis.normalized();
  int main_axis = 0;
  e.cwiseAbs().maxCoeff(&main_axis);
  const Vector3 side = Vector3::Unit((main_axis + 1) % 3);
  const Vector3 first = (side - e.dot(side) * e).normalized();
  const Vector3 second = e.cross(first);
  LateralBox box;
  for (Index p = 0; p < count; ++p) {
    if (left_out(state, p)) continue;
    const Particle& particle = model.particles[std::size_t(p)];
    const double at[] = {first.dot(particle.position), second.dot(particle.position)};
    for (std::size_t i = 0; i < 2; ++i) {
      box.low[i] = std::min(box.low[i], at[i] - particle.radius);
      box.high[i] = std::max(box.high[i], at[i] + particle.radius);
    }
  }
  return box;
}

double apparent_young(const std::vector<PlatenParticle>& base, const std::vector<PlatenParticle>& at,
                      const LateralBox& box) {
  const PlatenParticle below = platen(base), above = platen(at);
  const double height = std::abs(above.position - below.position);
  // A specimen in tension pulls its base towards the top; the support pulls back.
  return -below.reaction * height / (box.area() * (above.displacement - below.displacement));
}

double apparent_young(const Model& model, const State& state, const Output& output) {
  const auto platen_of = [&](const std::vector<Index>& particles) {
    std::vector<PlatenParticle> all;
    for (const Index p : particles) all.push_back(platen_particle(model, state, p, output.axis));
    return all;
  };
  return apparent_young(platen_of(output.base), platen_of(output.at),
                        lateral_box(model, state, Index(model.particles.size()), output.axis));
}

}  // namespace bondstatic
