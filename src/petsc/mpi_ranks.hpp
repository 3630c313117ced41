#pragma once

#include <cstddef>
#include <memory>

#include "system/ranks.hpp"

namespace bondstatic {

/// Starts MPI and joins the other processes of MPI_COMM_WORLD.
std::unique_ptr<Ranks> join_mpi_ranks();
/// With messages in pieces of at most so many bytes, at least 8.
std::unique_ptr<Ranks> join_mpi_ranks(std::size_t longest_piece);

}  // namespace bondstatic
