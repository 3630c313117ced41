// A specimen between two platens, as a compression test has it: what its particles do, and the means of it.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

/// One particle; NaN where it was left out.
struct SpecimenParticle {
  Vector3 position, displacement, reaction;

  bool left_out() const { return std::isnan(displacement[0]); }
};
SpecimenParticle specimen_particle(const Model& model, const State& state, Index particle);
std::vector<SpecimenParticle> specimen_particles(const Model& model, const State& state,
                                                 const std::vector<Index>& particles);

/// Components along a unit axis: means of the position and the displacement, sum of the reactions. What was
/// left out does not count; NaN where nothing is left.
struct Platen {
  double position = 0, displacement = 0, reaction = 0;
  double count = 0;
};
Platen platen(const std::vector<SpecimenParticle>& particles, const Vector3& axis);

/// Adds to `functional` that of `by_displacement` times the mean displacement along the axis, and
/// `by_reaction` times the sum of the reactions.
void add_platen(Functional& functional, const State& state, const std::vector<Index>& particles,
                const Vector3& axis, double by_displacement, double by_reaction);

/// Two unit vectors across a unit axis and each other: as near as can be to the global axes farthest from it.
std::array<Vector3, 2> lateral_directions(const Vector3& axis);

struct LateralBox {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{infinity, infinity}, high{-infinity, -infinity};

  void include(const LateralBox& other);
  double area() const { return (high[0] - low[0]) * (high[1] - low[1]); }
};
/// Of the particles 0 ... count-1 with their radii, across an axis of any length.
LateralBox lateral_box(const Model& model, const State& state, Index count, const Vector3& axis);

}  // namespace bondstatic
