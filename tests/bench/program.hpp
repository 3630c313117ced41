// The program itself, as a process of its own.
#pragma once

#include <string>
#include <vector>

namespace bondstatic::bench {

struct ProgramRun {
  double seconds = 0;      ///< from before it is started until it has ended
  double cpu_seconds = 0;  ///< of all its threads, the system's work for it included
  double peak_bytes = 0;   ///< largest resident size, under mpirun of the largest rank
};

struct Where {
  std::string output = "/dev/null";  ///< file for what it prints
  int cores = 0;                     ///< it is bound to so many; 0: as this process is
  int ranks = 0;                     ///< under `mpirun -np ranks`; 0: without mpirun
};

/// Throws std::runtime_error where it does not end with 0.
ProgramRun run_program(const std::vector<std::string>& arguments, const Where& where = {});

}  // namespace bondstatic::bench
