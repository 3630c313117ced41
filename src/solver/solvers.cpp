// The one table of backends, best first.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bondstatic/error.hpp"
#include "bondstatic/linear_solver.hpp"
#include "solver/backends.hpp"
#include "solver/petsc_module.hpp"

namespace bondstatic {

namespace {

struct Backend {
  SolverInfo info;
  std::unique_ptr<LinearSolver> (*make)(int threads);
  MakeModuleSolver PetscModule::*in_module = nullptr;  ///< instead of `make`: of the PETSc module
};

const std::vector<Backend>& backends() {
  static const std::vector<Backend> table{
#ifdef BONDSTATIC_WITH_CHOLMOD
      {{"cholmod", "CHOLMOD, supernodal Cholesky on BLAS, ordered on particles by METIS or AMD"},
       make_cholmod},
#endif
      {{"multigrid",
        "clump multigrid: conjugate gradients with rigid clumps of particles; for large packings; on MPI "
        "ranks",
        true},
       make_multigrid},
      {{"eigen", "Eigen's SimplicialLDLT, ordered on particles by AMD; for small models"}, make_eigen},
      {{"petsc", "PETSc's conjugate gradients with GAMG on the rigid modes, on MPI ranks; options behind --",
        true},
       nullptr,
       &PetscModule::iterative},
      {{"petsc-mumps", "MUMPS by PETSc, multifrontal, on MPI ranks; options behind --", true},
       nullptr,
       &PetscModule::direct},
  };
  return table;
}

}  // namespace

std::vector<SolverInfo> available_solvers() {
  std::vector<SolverInfo> list;
  const bool petsc = !petsc_module_path().empty();
  for (const Backend& backend : backends())
    if (!backend.in_module || petsc) list.push_back(backend.info);
  return list;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name, int threads,
                                          const std::vector<std::string>& backend_options) {
  std::vector<std::string> names{"auto"};
  for (const Backend& backend : backends()) {
    if (name == backend.info.name || name == "auto") {
      if (backend.in_module) return (petsc_module().*backend.in_module)(threads, backend_options);
      if (!backend_options.empty())
        throw Error(
            ExitCode::invalid_input,
            fmt::format("solver \"{}\" takes no options of its own, found {}\n    cure: leave them out",
                        backend.info.name, fmt::join(backend_options, " ")));
      return backend.make(threads);
    }
    names.push_back(backend.info.name);
  }
  throw Error(ExitCode::invalid_input,
              fmt::format("solver \"{}\" is not in this build\n    cure: choose one of {}", name,
                          fmt::join(names, ", ")));
}

}  // namespace bondstatic
