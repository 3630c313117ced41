// Which bodies have rows in the system and in which order: rank by rank, each rank's own bodies ascending.
#pragma once

#include <vector>

#include "system/incidence.hpp"

namespace bondstatic {

struct Layout {
  std::vector<Index> body;  ///< of each block row of this rank
  std::vector<Index> row;   ///< of each body, counted over all ranks; -1 where nothing of it is free
};

/// Own bodies of which something is free.
Index count_rows(const BondNetwork& network, const FreeDofs& dofs);

/// `first`: block rows of lower ranks. Copies have no row yet: it is for the ranks they belong to to say.
Layout lay_out(const BondNetwork& network, const FreeDofs& dofs, Index first);

/// Entries of an own body's block row as 6x6 blocks (both triangles): within the rank, and in all.
struct BlockCount {
  Index own = 0;
  Index all = 0;
};
BlockCount count_blocks(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                        Index body);

/// Twice the entries that an own body adds to the lower triangle of K without fill: its part of what the
/// direct solvers count, when summed over all bodies of all ranks. What stands between two bodies adds half
/// to each.
Index twice_the_entries(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                        Index body);

/// Throws Error (invalid_input) where a system of so many block rows, so many blocks of them on one rank, is
/// beyond the integers that PETSc was built with (`largest`).
void check_index_range(Index block_rows, Index blocks_on_a_rank, Index largest);

}  // namespace bondstatic
