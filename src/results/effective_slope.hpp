// How a quantity of a cell's stiffness changes with the stresses of the six load cases.
#pragma once

#include "bondstatic/sensitivity.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// `by_stiffness`: d(quantity)/d(EffectiveStiffness::stiffness), component by component; one functional for
/// each load case of `solution`, which has an effective stiffness.
Functionals effective_slope(const Matrix6& by_stiffness, const StaticSolution& solution);

}  // namespace bondstatic
