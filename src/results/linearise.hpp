// What an output's value changes by when the state changes a little: the derivative that sensitivities start
// from. Each quantity's own stands beside the quantity, in the tables.
#pragma once

#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// d(value of evaluate_outputs(), scale included)/d(states that it is made from). What was left out does not
/// count; the largest of several has the derivative of the first one that is as large. Empty where the value
/// depends on no state (positions, radii). `properties` are those of the model's bonds, in their order.
///
/// Throws Error (invalid_input), naming the output and the cure, where evaluate_outputs() does, where there
/// is no value (NaN), and where there is no derivative that could be told: a magnitude that is zero but for
/// rounding, a stress with one in it, the misfit of a stiffness that is isotropic. A magnitude that is
/// exactly zero is held, or zero by symmetry, and stays so whatever the bonds' parameters: it changes by
/// nothing.
Functionals linearise(const Output& output, const Model& model, const StaticSolution& solution,
                      const std::vector<BondProperties>& properties);

}  // namespace bondstatic
