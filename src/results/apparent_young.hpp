// Young's modulus of a specimen between two platens, as a compression test measures it.
#pragma once

#include "bondstatic/output.hpp"
#include "results/specimen.hpp"

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

/// Its derivative, of load case 0.
Functional apparent_young_slope(const Model& model, const State& state, const Output& output);

/// Of a specimen whose particles are not all in one place: those of the platens, and the box of all.
double apparent_young(const Output& output, const std::vector<SpecimenParticle>& base,
                      const std::vector<SpecimenParticle>& at, const LateralBox& box);

}  // namespace bondstatic
