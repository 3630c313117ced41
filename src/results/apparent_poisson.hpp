// Poisson's ratio of a specimen between two platens, as strain gauges at mid-height measure it.
#pragma once

#include "bondstatic/output.hpp"
#include "results/specimen.hpp"

namespace bondstatic {

/// nu = -(lateral strain) / (axial strain):
///
///     axial    mean displacement of `output.at` less that of `output.base` along `output.axis`, over the
///              distance of their mean centres along it
///     lateral  mean of the normal strains in the two directions across the axis, of the affine motion that
///              is nearest to the displacements of `output.middle` (least squares); where that is empty, of
///              the particles whose centres lie in the middle third between the platens
///
/// The two directions are those of apparent_young's box. The motion is fitted to all three coordinates, so
/// that neither shear nor how the centres happen to lie enters the strains; a layer across the axis is
/// enough. Particles that were left out (NaN) count nowhere; NaN where a platen has no particle left.
///
/// Throws Error (invalid_input) where the centres of the middle do not tell the lateral strains: fewer than
/// three, or all in one plane that is not across the axis.
double apparent_poisson(const Model& model, const State& state, const Output& output);

/// Its derivative, of load case 0; throws the same.
Functional apparent_poisson_slope(const Model& model, const State& state, const Output& output);

/// Of a specimen whose particles are not all in one place; throws the same.
double apparent_poisson(const Output& output, const std::vector<SpecimenParticle>& base,
                        const std::vector<SpecimenParticle>& at, const std::vector<SpecimenParticle>& middle);

}  // namespace bondstatic
