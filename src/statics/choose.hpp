// The solver of a solve: the one asked for, or with "auto" the one that will be done first and fits.
#pragma once

#include <memory>
#include <string>

#include "bondstatic/linear_solver.hpp"
#include "bondstatic/statics.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

/// A solver that has analysed the network.
struct Chosen {
  std::unique_ptr<LinearSolver> solver;
  std::string name;
  std::string reason;  ///< "" where it was asked for by name
  AnalysisReport analysis;
};

/// Throws Error (invalid_input) for an unknown name, MemoryError with the alternative where the solve would
/// not fit. `solves`: as many will follow on one factorisation, which an iterative solver pays for each.
Chosen choose(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
              const StaticOptions& options, int threads, int solves = 1);

/// The direct solver that may still do it where an iterative one, chosen by "auto", gave up. Null solver
/// where none fits.
Chosen choose_direct(const BondNetwork& network, const FreeDofs& dofs, const StaticOptions& options,
                     int threads);

}  // namespace bondstatic
