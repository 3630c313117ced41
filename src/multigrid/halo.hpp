// What a level shares with other ranks. Every rank has the links that touch its own bodies, and copies of the
// bodies at their far ends, so that K u of its own rows needs no more than the copies' motions, brought up to
// date. Clumps never reach over to another rank; the clumps of copies are the copies of the coarser level. In
// a run of one process there are no copies and nothing is shared.
#pragma once

#include <array>
#include <vector>

#include "system/refresh.hpp"

namespace bondstatic::multigrid {

struct Halo {
  Ranks* ranks = nullptr;
  std::vector<Neighbour> neighbours;  ///< bodies of a packing, or rows of a level
};

/// Copies take their owners' values. Called by all ranks.
template <class T>
void refresh(const Halo& halo, std::vector<T>& values) {
  if (halo.ranks) bondstatic::refresh(*halo.ranks, halo.neighbours, values);
}

/// Added up over the ranks in their order, the same on all.
template <std::size_t Count>
std::array<double, Count> over_all_ranks(const Halo& halo, const std::array<double, Count>& mine) {
  if (!halo.ranks) return mine;
  const std::vector<double> all = halo.ranks->all_gather(mine);
  std::array<double, Count> sum{};
  for (std::size_t i = 0; i < all.size(); ++i) sum[i % Count] += all[i];
  return sum;
}

inline Index over_all_ranks(const Halo& halo, Index mine) {
  return Index(over_all_ranks(halo, std::array{double(mine)})[0]);
}

}  // namespace bondstatic::multigrid
