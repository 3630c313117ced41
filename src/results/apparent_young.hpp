// Young's modulus of a specimen between two platens, as a compression test measures it.
#pragma once

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
double apparent_young(const Model& model, const State& result, const Output& output);

}  // namespace bondstatic
