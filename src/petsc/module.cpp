// The one symbol that the module shows.
#include "petsc/backends.hpp"
#include "petsc/mpi_ranks.hpp"
#include "solver/petsc_module.hpp"

extern "C" __attribute__((visibility("default"))) const bondstatic::PetscModule* bondstatic_petsc_module() {
  static const bondstatic::PetscModule module{bondstatic::petsc_module_abi, BONDSTATIC_VERSION,
                                              bondstatic::make_petsc_iterative, bondstatic::make_petsc_direct,
                                              bondstatic::join_mpi_ranks};
  return &module;
}
