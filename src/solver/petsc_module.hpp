// PETSc and MPI are a hundred libraries, half a second at the start and a choice that few users make. They
// are in a module of their own (libbondstatic_petsc.so) that is loaded when it is asked for
// (io/module_file.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bondstatic/linear_solver.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// To be counted up with every change to the types that cross.
inline constexpr int petsc_module_abi = 2;

using MakeModuleSolver = std::unique_ptr<LinearSolver> (*)(int threads,
                                                           const std::vector<std::string>& options);

/// What the module's entry point, `bondstatic_petsc_module`, returns a pointer to.
struct PetscModule {
  int abi;
  const char* version;
  MakeModuleSolver iterative;
  MakeModuleSolver direct;
  std::unique_ptr<Ranks> (*join_ranks)();
};

/// Where the module lies; "" where it is nowhere. Loads nothing.
std::string petsc_module_path();

/// Loads the module at the first call. Throws Error (invalid_input) that says how to come by one where there
/// is none, or one of another version.
const PetscModule& petsc_module();

}  // namespace bondstatic
