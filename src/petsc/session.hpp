// PETSc started, its options, and its errors as ours. PETSc is one state a process whoever calls it; this is
// where that state is kept in hand.
#pragma once

#include <petscsys.h>

#include <string>
#include <vector>

namespace bondstatic {

/// Starts MPI and PETSc at the first call (about 0.4 s) and hands the options to PETSc's own data base, in
/// place of those of an earlier call. What PETSc prints goes to standard error, its signal handlers are off.
/// Throws Error (invalid_input) for an argument that is neither an option (-name) nor the value of one.
void start_petsc(const std::vector<std::string>& options);

/// Throws where a call into PETSc failed, with PETSc's own words: MemoryError; Error (invalid_input) where it
/// did not understand an option; else Error (internal).
void check_petsc(PetscErrorCode code);

/// Throws Error (invalid_input) that names those of the options nobody has asked for until now: misspelt, or
/// of a method that does not run.
void refuse_unused(const std::vector<std::string>& options);

}  // namespace bondstatic
