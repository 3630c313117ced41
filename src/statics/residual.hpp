// r = f - B^T C (B u + strain) by body, bond by bond in natural form.
#pragma once

#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// What is prescribed is part of `motion`; rows of prescribed degrees of freedom are minus the reactions.
BodyVectors<Extended> residual(const BondNetwork& network, const Boundary& boundary,
                               const BodyVectors<Extended>& motion, int threads);

}  // namespace bondstatic
