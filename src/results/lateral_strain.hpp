// Mean lateral strain of a part of a specimen, as a sum over its particles.
#pragma once

#include "bondstatic/output.hpp"
#include "results/specimen.hpp"

namespace bondstatic {

/// By particle, g with (mean lateral strain) = sum of g . displacement, of the affine motion that fits best;
/// they sum up to zero, and what was left out has zero. `output` is for messages: throws Error
/// (invalid_input) where the centres do not tell the strain.
std::vector<Vector3> lateral_strain_weights(const Output& output,
                                            const std::vector<SpecimenParticle>& particles);

}  // namespace bondstatic
