// Several processes started by an MPI launcher (mpirun, srun) as one run. MPI itself is known only to the
// module that petsc_module.hpp loads.
#pragma once

#include <memory>
#include <string>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// What a launcher says of this process in its environment (Open MPI, PMI, PMIx); {0, 1} without a launcher.
/// To be asked before MPI runs.
struct Launched {
  int rank = 0;
  int ranks = 1;
};
Launched launched();

/// How one rank ended a part of the work.
struct RankStatus {
  ExitCode code = ExitCode::done;
  std::string message;  ///< with a code other than done
};

class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Ranks on this machine, at least 1.
  virtual int on_this_machine() const = 0;

  /// Called by all ranks when they have done with a part, well or not. Returns the same on all of them: done
  /// where all are, else the status of the lowest rank that failed. A rank that failed waits a few seconds
  /// for the others to arrive; where they do not, because they wait for it in the middle of a solve, it says
  /// what happened by `say` and ends all of them with its exit code.
  virtual RankStatus agree(const RankStatus& mine, void (*say)(const RankStatus&)) = 0;
};

}  // namespace bondstatic
