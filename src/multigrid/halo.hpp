// What a level shares with other ranks. Every rank has the links that touch its own bodies, and copies of the
// bodies at their far ends, so that K u of its own rows needs no more than the copies' motions, brought up to
// date. Clumps never reach over to another rank; the clumps of copies are the copies of the coarser level. In
// a run of one process there are no copies and nothing is shared.
#pragma once

#include <array>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "bondstatic/network.hpp"
#include "system/ranks.hpp"

namespace bondstatic::multigrid {

struct Halo {
  Ranks* ranks = nullptr;
  std::vector<Neighbour> neighbours;  ///< bodies of a packing, or rows of a level
};

/// Overwrites the values of copies by their owners'. Called by all ranks.
template <class T>
void refresh(const Halo& halo, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (!halo.ranks) return;
  const std::size_t count = halo.neighbours.size();
  std::vector<std::vector<T>> sent(count), taken(count);
  std::vector<Ranks::Parcel> out, in;
  for (std::size_t n = 0; n < count; ++n) {
    const Neighbour& neighbour = halo.neighbours[n];
    for (const Index i : neighbour.lent) sent[n].push_back(values[std::size_t(i)]);
    taken[n].resize(neighbour.borrowed.size());
    out.push_back({neighbour.rank, std::as_writable_bytes(std::span(sent[n]))});
    in.push_back({neighbour.rank, std::as_writable_bytes(std::span(taken[n]))});
  }
  halo.ranks->exchange(out, in);
  for (std::size_t n = 0; n < count; ++n) {
    const auto& borrowed = halo.neighbours[n].borrowed;
    for (std::size_t i = 0; i < borrowed.size(); ++i) values[std::size_t(borrowed[i])] = taken[n][i];
  }
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
