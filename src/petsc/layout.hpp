// Which bodies have rows in the system, in which order, and on which rank: cut by geometry, so that a rank's
// bodies lie together and few links cross.
#pragma once

#include <span>
#include <vector>

#include "system/incidence.hpp"

namespace bondstatic {

struct Layout {
  std::vector<Index> body;   ///< of each block row: rank by rank, ascending within one
  std::vector<Index> row;    ///< block row of each body, -1 where nothing of it is free
  std::vector<Index> first;  ///< first block row of each rank; size ranks + 1

  Index rows() const { return Index(body.size()); }
  std::span<const Index> bodies_of(int rank) const {
    const auto begin = first[std::size_t(rank)], end = first[std::size_t(rank) + 1];
    return {body.data() + begin, std::size_t(end - begin)};
  }
};

/// The same on every rank. `positions` are those of body_positions(), one a body of the network.
Layout lay_out(std::span<const Vector3> positions, const FreeDofs& dofs, int ranks);

/// Entries of the block rows of `bodies` as 6x6 blocks (both triangles): within the rank that has them, and
/// in all.
struct BlockCount {
  Index own = 0;
  Index all = 0;
};
BlockCount count_blocks(const BondNetwork& network, const Incidence& incidence, const Layout& layout,
                        int rank, Index body);

/// Throws Error (invalid_input) where a system of so many block rows, so many blocks of them on one rank, is
/// beyond the integers that PETSc was built with (`largest`).
void check_index_range(Index block_rows, Index blocks_on_a_rank, Index largest);

}  // namespace bondstatic
