#include "results/apparent_young.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bondstatic {

namespace {

bool left_out(const State& result, Index particle) {
  return std::isnan(result.displacement[std::size_t(particle)][0]);
}

struct Platen {
  double centre = 0, displacement = 0, reaction = 0;
};

/// Means of the position and the displacement along the axis, sum of the reactions.
Platen platen(const Model& model, const State& result, const std::vector<Index>& particles,
              const Vector3& axis) {
  Platen sum;
  double count = 0;
  for (const Index p : particles) {
    if (left_out(result, p)) continue;
    const std::size_t i = std::size_t(p);
    sum.centre += axis.dot(model.particles[i].position);
    sum.displacement += axis.dot(result.displacement[i].head<3>());
    sum.reaction += axis.dot(result.reaction[i].head<3>());
    ++count;
  }
  return {sum.centre / count, sum.displacement / count, sum.reaction};
}

double width(const Model& model, const State& result, const Vector3& direction) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    if (left_out(result, Index(i))) continue;
    const double centre = direction.dot(model.particles[i].position);
    low = std::min(low, centre - model.particles[i].radius);
    high = std::max(high, centre + model.particles[i].radius);
  }
  return high - low;
}

}  // namespace

double apparent_young(const Model& model, const State& result, const Output& output) {
  const Vector3 axis = output.axis.normalized();
  int main_axis = 0;
  axis.cwiseAbs().maxCoeff(&main_axis);
  const Vector3 side = Vector3::Unit((main_axis + 1) % 3);
  const Vector3 first = (side - axis.dot(side) * axis).normalized();
  const Vector3 second = axis.cross(first);
  const double area = width(model, result, first) * width(model, result, second);

  const Platen base = platen(model, result, output.base, axis);
  const Platen top = platen(model, result, output.at, axis);
  const double height = std::abs(top.centre - base.centre);
  // A specimen in tension pulls its base towards the top; the support pulls back.
  return -base.reaction * height / (area * (top.displacement - base.displacement));
}

}  // namespace bondstatic
