// How good an answer is.
#pragma once

#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// Forces that a relative motion of rounding size in every link would need, with random signs: B^T C e with
/// |e| <= 4 eps (|B| |u| + |strain|). The motion they cause shows what the natural form cannot see of u.
BodyVectors<double> rounding_forces(const BondNetwork& network, const Incidence& incidence,
                                    const BodyVectors<double>& motion, const Matrix3& strain);

/// Oettli and Prager's componentwise measure, of the answer as it is written: rounded once to double. Where
/// all terms of a row vanish by symmetry but for noise, the row is held against what it could carry where
/// everything moved by `size` (M. Arioli, J. W. Demmel, I. S. Duff, SIAM J. Matrix Anal. Appl. 10, 1989). On
/// several ranks, of own bodies.
double backward_error(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                      const Boundary& boundary, const BodyVectors<double>& motion, double size, int threads);

}  // namespace bondstatic
