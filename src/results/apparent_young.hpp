// Young's modulus of a specimen between two platens, as a compression test measures it.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

/// E = F H / (A d), tension and compression alike positive:
///
///     F  sum of the reactions on `output.base` along `output.axis`
///     d  mean displacement of `output.at` less that of `output.base`, along the axis
///     H  distance of the mean centres of the two along the axis
///     A  lateral bounding box of all particles with their radii
///
/// Particles that were left out (NaN) count nowhere; NaN where a platen has no particle left.
/// The box stands on the two global axes farthest from `output.axis`, made perpendicular to it.
double apparent_young(const Model& model, const State& state, const Output& output);

// Its parts, for a specimen whose particles are not all in one place.

/// One particle of a platen: components along the axis. NaN where it was left out.
struct PlatenParticle {
  double position = 0, displacement = 0, reaction = 0;
};
PlatenParticle platen_particle(const Model& model, const State& state, Index particle, const Vector3& axis);

struct LateralBox {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{infinity, infinity}, high{-infinity, -infinity};

  void include(const LateralBox& other);
  double area() const { return (high[0] - low[0]) * (high[1] - low[1]); }
};
/// Of the particles 0 ... count-1.
LateralBox lateral_box(const Model& model, const State& state, Index count, const Vector3& axis);

double apparent_young(const std::vector<PlatenParticle>& base, const std::vector<PlatenParticle>& at,
                      const LateralBox& box);

}  // namespace bondstatic
