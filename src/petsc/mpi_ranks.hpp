#pragma once

#include <memory>

#include "solver/ranks.hpp"

namespace bondstatic {

/// Starts MPI and joins the other processes of MPI_COMM_WORLD.
std::unique_ptr<Ranks> join_mpi_ranks();

}  // namespace bondstatic
