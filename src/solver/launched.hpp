// Several processes started by an MPI launcher (mpirun, srun) as one run.
#pragma once

namespace bondstatic {

/// What a launcher says of this process in its environment (Open MPI, PMI, PMIx); {0, 1} without a launcher.
/// To be asked before MPI runs.
struct Launched {
  int rank = 0;
  int ranks = 1;
};
Launched launched();

}  // namespace bondstatic
