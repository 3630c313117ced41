// What a factor and an answer must be before they are used. Both throw AccuracyError.
#pragma once

#include "bondstatic/linear_solver.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic {

/// That it did not break down; says at which particle it did.
void check_pivots(const Model& model, const FreeDofs& dofs, const FactorReport& factor);

void check_backward_error(double found, double asked);

}  // namespace bondstatic
