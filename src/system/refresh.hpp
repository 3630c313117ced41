// Copies of other ranks' bodies brought up to date.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "bondstatic/network.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// Overwrites the values of copies by their owners'; a value a body. Called by all ranks.
template <class T>
void refresh(Ranks& ranks, std::span<const Neighbour> neighbours, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t count = neighbours.size();
  std::vector<std::vector<T>> sent(count), taken(count);
  std::vector<Ranks::Parcel> out, in;
  for (std::size_t n = 0; n < count; ++n) {
    const Neighbour& neighbour = neighbours[n];
    sent[n].reserve(neighbour.lent.size());
    for (const Index i : neighbour.lent) sent[n].push_back(values[std::size_t(i)]);
    taken[n].resize(neighbour.borrowed.size());
    out.push_back({neighbour.rank, std::as_writable_bytes(std::span(sent[n]))});
    in.push_back({neighbour.rank, std::as_writable_bytes(std::span(taken[n]))});
  }
  ranks.exchange(out, in);
  for (std::size_t n = 0; n < count; ++n) {
    const auto& borrowed = neighbours[n].borrowed;
    for (std::size_t i = 0; i < borrowed.size(); ++i) values[std::size_t(borrowed[i])] = taken[n][i];
  }
}

}  // namespace bondstatic
