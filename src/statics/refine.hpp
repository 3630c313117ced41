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

/// Of the largest entry: as far as derivatives, and answers that others begin from, need to go.
inline constexpr double early_enough = 1e-20;

struct Refined {
  BodyVectors<Extended> motion;  ///< prescribed values included; what is negligible is zero
  Accuracy accuracy;             ///< errors and number of refinements; balances are left to recovery
  /// What the rounding of the natural form adds to the forward error; 0 where it was not asked (in_brief).
  double rounding = 0;
};

/// What solves took in all where they iterate: iterations of the slowest load case, notes for the user.
struct Effort {
  Index iterations = 0;
  std::vector<std::string> notes;
};

/// Where a solve goes on from.
struct FromBefore {
  /// Of all cases; prescribed values are replaced by the boundary's own. Null: from these alone.
  const std::vector<BodyVectors<Extended>>* motions = nullptr;
  /// A direct solver ends where what is left is below this part of the largest entry.
  double enough = early_enough;
  /// Sizes of the corrections that led to `motions`, one a case; empty where they are not known.
  std::vector<double> came_by = {};
  /// The forward error without what the rounding of the natural form does to the answer: that takes a solve.
  bool in_brief = false;
};

/// Solves all load cases of one factorisation at once; `solver` may be null where nothing is unknown. Throws
/// AccuracyError where corrections do not contract. `progress` hears of each round of an iterative solver;
/// may be null. `ranks`: where the network is one rank's share. `before`: absent, from
/// the prescribed values to the last digit.
std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver* solver, double pivot_ratio, int threads, Effort& effort,
                                   const std::function<void(const std::string&)>& progress,
                                   Ranks* ranks = nullptr, const FromBefore& before = {});

/// The motions alone, as far as derivatives need them: what is left is below 1e-20 of the largest entry, or
/// what `before` says, by what the corrections of a direct solver tell. One process. Throws likewise.
std::vector<BodyVectors<Extended>> solve_adjoint(const BondNetwork& network, const FreeDofs& dofs,
                                                 const std::vector<const Boundary*>& cases,
                                                 LinearSolver* solver, double pivot_ratio, int threads,
                                                 const FromBefore& before = {});

}  // namespace bondstatic
