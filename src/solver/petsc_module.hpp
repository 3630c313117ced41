// PETSc and MPI are a hundred libraries, half a second at the start and a choice that few users make. They
// are in a module of their own (libbondstatic_petsc.so) that is loaded when it is asked for.
//
// The module carries its own copies of the few functions of this library that it needs and resolves nothing
// from the program, so it serves programs linked to the static library, to the shared one, and with or
// without exported symbols. Data crosses as types of headers both were built from, which `abi` and `version`
// stand for. Exceptions cross, as g++'s runtime, which both share, compares types by their names.
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
inline constexpr const char* petsc_module_file = "libbondstatic_petsc.so";
inline constexpr const char* petsc_module_entry = "bondstatic_petsc_module";

/// Where the module lies; "" where it is nowhere. Looked for in the folder that BONDSTATIC_MODULES names;
/// beside the program or library that this code is part of and the two folders above it (a build folder); in
/// its lib folder; where this was installed to. Loads nothing.
std::string petsc_module_path();

/// Loads the module at the first call. Throws Error (invalid_input) that says how to come by one where there
/// is none, or one of another version.
const PetscModule& petsc_module();

}  // namespace bondstatic
