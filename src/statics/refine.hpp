// Iterative refinement to the last digit: corrections from a double factorisation, residuals bond by bond in
// natural form in extended precision.
//
//     r = f - B^T C B u (extended),   K d = r (double factor),   u += d
//
// The error of u contracts by the relative error of the factorisation each time, down to the rounding of the
// natural form in extended precision, far below the last digit of a double. An iterative solver costs as much
// again each time, so it is asked no further than a double tells: until what the next correction would be,
// were it to shrink as the last one did, is below the last digit, and what the next residual would be is
// below rounding of the loads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bondstatic/linear_solver.hpp"
#include "bondstatic/statics.hpp"
#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct Refined {
  BodyVectors<Extended> motion;  ///< prescribed values included; what is negligible is zero
  Accuracy accuracy;             ///< errors and number of refinements; balances are left to recovery
};

/// What iterative solves took in all: iterations of the slowest load case, notes for the user.
struct Effort {
  Index iterations = 0;
  std::vector<std::string> notes;
};

/// Solves all load cases of one factorisation at once; `solver` may be null where nothing is unknown. Throws
/// AccuracyError where corrections do not contract. `progress` hears of each round of an iterative solver;
/// may be null. `ranks`: where the network is one rank's share.
std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver* solver, double pivot_ratio, int threads, Effort& effort,
                                   const std::function<void(const std::string&)>& progress,
                                   Ranks* ranks = nullptr);

/// The motions alone, as far as derivatives need them: what is left is below 1e-20 of the largest entry, by
/// what the corrections of a direct solver tell. One process. Throws likewise.
std::vector<BodyVectors<Extended>> solve_adjoint(const BondNetwork& network, const Incidence& incidence,
                                                 const FreeDofs& dofs,
                                                 const std::vector<const Boundary*>& cases,
                                                 LinearSolver* solver, double pivot_ratio, int threads);

}  // namespace bondstatic
