// Which pairs of particles are bonded.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "bondstatic/types.hpp"
#include "io/wide.hpp"

namespace bondstatic {

/// A hash table in one array, at most two thirds full: no memory but eight bytes a place.
class PairSet {
 public:
  PairSet(Index particles, Index expected) : particles_(particles) { make_room(expected); }

  /// False where the pair, in either order, is there already.
  bool add(Index a, Index b) {
    if (3 * (size_ + 1) > 2 * Index(keys_.size())) make_room(2 * size_ + 1);
    const bool is_new = place(key_of(a, b));
    size_ += is_new;
    return is_new;
  }

  /// Begins to bring what add() of the pair will look at.
  ALWAYS_INLINE void fetch(Index a, Index b) const { bondstatic::fetch(&keys_[place_of(key_of(a, b))]); }

 private:
  static constexpr Index none = -1;

  Index key_of(Index a, Index b) const { return std::min(a, b) * particles_ + std::max(a, b); }
  std::size_t place_of(Index key) const {
    return std::size_t(std::uint64_t(key) * 0x9e3779b97f4a7c15u >> shift_);
  }

  bool place(Index key) {
    const std::size_t mask = keys_.size() - 1;
    std::size_t at = place_of(key);
    for (; keys_[at] != none; at = (at + 1) & mask)
      if (keys_[at] == key) return false;
    keys_[at] = key;
    return true;
  }

  void make_room(Index pairs) {
    const std::size_t places = std::bit_ceil(std::size_t(3 * pairs / 2 + 64));
    std::vector<Index> old(places, none);
    old.swap(keys_);
    shift_ = 64 - std::bit_width(places - 1);
    for (const Index key : old)
      if (key != none) place(key);
  }

  Index particles_;
  Index size_ = 0;
  int shift_ = 64;
  std::vector<Index> keys_;
};

}  // namespace bondstatic
