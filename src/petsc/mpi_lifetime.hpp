// MPI can be started once in a process, and ends with it.
#pragma once

#include <mpi.h>

namespace bondstatic {

/// Starts MPI at the first call, unless somebody else has; what was started here is ended when the program
/// exits. Ranks that wait give their core away (Open MPI would spin). Throws Error where MPI cannot start.
void start_mpi();

/// Throws Error (internal) with MPI's own words where `code` is not MPI_SUCCESS.
void check_mpi(int code);

}  // namespace bondstatic
