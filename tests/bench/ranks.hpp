// The program on MPI ranks against itself in one process: times, memory, and what the machine's memory gives.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

struct OnRanks {
  Index particles = 125000;          ///< about
  std::vector<int> ranks;            ///< launched by mpirun; empty: 2
  std::vector<std::string> solvers;  ///< empty: multigrid and petsc
};

void compare_ranks(OnRanks asked);

}  // namespace bondstatic::bench
