#include "solver/petsc_module.hpp"

#include "io/module_file.hpp"

namespace bondstatic {

namespace {

// Open MPI's own plug-ins look for its symbols among the global ones.
constexpr ModuleFile file{.name = "PETSc",
                          .file = "libbondstatic_petsc.so",
                          .entry = "bondstatic_petsc_module",
                          .abi = petsc_module_abi,
                          .package = "petsc-dev",
                          .option = "BONDSTATIC_PETSC",
                          .to_all = true};

}  // namespace

std::string petsc_module_path() {
  return module_path(file);
}

const PetscModule& petsc_module() {
  static const PetscModule& module = *static_cast<const PetscModule*>(load_module(file));
  return module;
}

}  // namespace bondstatic
