#include "results/specimen.hpp"

#include <algorithm>
#include <cmath>

namespace bondstatic {

SpecimenParticle specimen_particle(const Model& model, const State& state, Index particle) {
  const auto p = std::size_t(particle);
  return {model.particles[p].position, state.displacement[p].head<3>(), state.reaction[p].head<3>()};
}

std::vector<SpecimenParticle> specimen_particles(const Model& model, const State& state,
                                                 const std::vector<Index>& particles) {
  std::vector<SpecimenParticle> all;
  for (const Index p : particles) all.push_back(specimen_particle(model, state, p));
  return all;
}

Platen platen(const std::vector<SpecimenParticle>& particles, const Vector3& axis) {
  Platen sum;
  for (const SpecimenParticle& particle : particles) {
    if (particle.left_out()) continue;
    sum.position += axis.dot(particle.position);
    sum.displacement += axis.dot(particle.displacement);
    sum.reaction += axis.dot(particle.reaction);
    ++sum.count;
  }
  return {sum.position / sum.count, sum.displacement / sum.count, sum.reaction, sum.count};
}

void add_platen(Functional& functional, const State& state, const std::vector<Index>& particles,
                const Vector3& axis, double by_displacement, double by_reaction) {
  const auto left_out = [&](Index p) { return std::isnan(state.displacement[std::size_t(p)][0]); };
  const auto out = std::count_if(particles.begin(), particles.end(), left_out);
  const double count = double(Index(particles.size()) - out);
  Vector6 along = Vector6::Zero();
  along.head<3>() = axis;
  for (const Index p : particles) {
    if (left_out(p)) continue;
    functional.displacement.emplace_back(p, by_displacement / count * along);
    if (by_reaction != 0) functional.reaction.emplace_back(p, by_reaction * along);
  }
}

std::array<Vector3, 2> lateral_directions(const Vector3& axis) {
  int main_axis = 0;
  axis.cwiseAbs().maxCoeff(&main_axis);
  const Vector3 side = Vector3::Unit((main_axis + 1) % 3);
  const Vector3 first = (side - axis.dot(side) * axis).normalized();
  return {first, axis.cross(first)};
}

void LateralBox::include(const LateralBox& other) {
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

LateralBox lateral_box(const Model& model, const State& state, Index count, const Vector3& axis) {
  const auto directions = lateral_directions(axis.normalized());
  LateralBox box;
  for (Index p = 0; p < count; ++p) {
    if (std::isnan(state.displacement[std::size_t(p)][0])) continue;
    const Particle& particle = model.particles[std::size_t(p)];
    for (std::size_t i = 0; i < 2; ++i) {
      const double at = directions[i].dot(particle.position);
      box.low[i] = std::min(box.low[i], at - particle.radius);
      box.high[i] = std::max(box.high[i], at + particle.radius);
    }
  }
  return box;
}

}  // namespace bondstatic
