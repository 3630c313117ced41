// The methods of the module. Both run on all ranks of PETSC_COMM_WORLD together: every rank makes the same
// calls in the same order, with the same options and as many right-hand sides. One process may hold a whole
// network; of several, each holds its share (network.share) and gives and gets values of its share.
#pragma once

#include <memory>

#include "bondstatic/linear_solver.hpp"

namespace bondstatic {

/// Conjugate gradients; preconditioned by GAMG with the rigid modes unless the options say otherwise.
std::unique_ptr<LinearSolver> make_petsc_iterative(int threads, const std::vector<std::string>& options);

/// MUMPS, L D L^T.
std::unique_ptr<LinearSolver> make_petsc_direct(int threads, const std::vector<std::string>& options);

}  // namespace bondstatic
