// Mass-weighted unknowns y = M^1/2 x: in them K x = w^2 M x is a symmetric eigenproblem.
#pragma once

#include "bondstatic/modes.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// Diagonal of M^1/2, by unknown. Throws Error (invalid_input) for a mass that is not positive and finite.
Eigen::VectorXd mass_roots(const BodyMasses& masses, const FreeDofs& dofs);

/// x = M^-1/2 y as one motion a body, zero where prescribed.
void motion_of(const double* y, const Eigen::VectorXd& roots, const FreeDofs& dofs,
               BodyVectors<double>& motion);

/// x^T K x, link by link, so that nothing cancels.
double twice_energy(const BondNetwork& network, const BodyVectors<double>& motion);

}  // namespace bondstatic
