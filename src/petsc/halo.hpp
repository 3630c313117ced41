// What copies of bodies know from the ranks that the bodies belong to.
#pragma once

#include <algorithm>
#include <vector>

#include "bondstatic/network.hpp"
#include "petsc/messages.hpp"

namespace bondstatic {

/// Sets the values of copies to those that their own ranks hold. Body p has values[first(p)] up to, but not
/// including, values[first(p + 1)], as many on either side. Collective over neighbours.
template <class Value, class First>
void fill_copies(const NetworkShare& share, const First& first, Value* values, MPI_Comm among) {
  const auto size_of = [&](const std::vector<Index>& bodies) {
    Index size = 0;
    for (const Index p : bodies) size += first(p + 1) - first(p);
    return std::size_t(size);
  };
  std::vector<std::vector<Value>> coming, going;
  Messages messages(among);
  for (const Neighbour& neighbour : share.neighbours) {
    auto& buffer = coming.emplace_back(size_of(neighbour.borrowed));
    messages.receive(buffer.data(), buffer.size() * sizeof(Value), neighbour.rank);
  }
  for (const Neighbour& neighbour : share.neighbours) {
    auto& buffer = going.emplace_back(size_of(neighbour.lent));
    auto next = buffer.begin();
    for (const Index p : neighbour.lent) next = std::copy(values + first(p), values + first(p + 1), next);
    messages.send(buffer.data(), buffer.size() * sizeof(Value), neighbour.rank);
  }
  messages.wait();
  auto buffer = coming.cbegin();
  for (const Neighbour& neighbour : share.neighbours) {
    auto next = (buffer++)->cbegin();
    for (const Index p : neighbour.borrowed) {
      const Index count = first(p + 1) - first(p);
      std::copy_n(next, count, values + first(p));
      next += count;
    }
  }
}

}  // namespace bondstatic
