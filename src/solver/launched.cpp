#include "solver/launched.hpp"

#include <cstdlib>

namespace bondstatic {

namespace {

int number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? std::atoi(text) : otherwise;
}

}  // namespace

Launched launched() {
  // Open MPI's mpirun; MPICH's and Intel's; Slurm's step, which tells the number of tasks for any MPI.
  constexpr const char* sizes[][2] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                      {"PMI_SIZE", "PMI_RANK"},
                                      {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}};
  for (const auto& [size, rank] : sizes)
    if (number(size, 0) > 0) return {number(rank, 0), number(size, 1)};
  return {};
}

}  // namespace bondstatic
