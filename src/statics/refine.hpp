// Iterative refinement to the last digit: corrections from a double factorisation, residuals bond by bond in
// natural form in extended precision.
//
//     r = f - B^T C B u (extended),   K d = r (double factor),   u += d
//
// The error of u contracts by the relative error of the factorisation each time, down to the rounding of the
// natural form in extended precision, far below the last digit of a double.
#pragma once

#include <vector>

#include "bondstatic/linear_solver.hpp"
#include "bondstatic/statics.hpp"
#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

struct Refined {
  BodyVectors<Extended> motion;  ///< prescribed values included; what is negligible is zero
  Accuracy accuracy;             ///< errors and number of refinements; balances are left to recovery
};

/// Solves all load cases of one factorisation at once. Throws AccuracyError where corrections do not
/// contract.
std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver& solver, double pivot_ratio, int threads);

}  // namespace bondstatic
