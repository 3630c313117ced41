// The commands of the program. Each prints its answer to standard output, throws Error where it fails, and
// returns what the program ends with.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct SolveArguments {
  std::string file;
  std::string folder;                        ///< of the results; "" writes none
  std::vector<std::string> overrides;        ///< KEY=VALUE
  std::string solver;                        ///< "": the case's choice
  std::vector<std::string> backend_options;  ///< what stands behind --, for the solver's own library
  int threads = 0;                           ///< 0: the case's choice
  bool json = false;
};
/// `ranks`: the processes that solve it together, null for one.
ExitCode solve(const SolveArguments& arguments, Ranks* ranks = nullptr);

struct SweepArguments {
  SolveArguments solve;
  std::vector<std::string> vary;  ///< KEY=v1,v2 or KEY1:KEY2=a1:b1,a2:b2
};
ExitCode sweep(const SweepArguments& arguments);

struct RelaxArguments {
  SolveArguments solve;
  bool resume = false;
  double checkpoint_every = 60;  ///< seconds
};
ExitCode relax(const RelaxArguments& arguments);

ExitCode check(const SolveArguments& arguments);

/// All laws where `name` is empty.
ExitCode laws(const std::string& name, bool json);

ExitCode solvers(bool json);

/// What --version prints: version, solvers, BLAS.
std::string version_text();

}  // namespace bondstatic
