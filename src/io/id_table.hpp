// Which position has an id: a plain array where ids are about as many as they are large, a map for the rest.
#pragma once

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "bondstatic/types.hpp"
#include "io/wide.hpp"

namespace bondstatic {

class IdTable {
 public:
  /// Says that so many ids are to be added next, and so how large an array is worth its memory.
  void expect(Index more) { dense_below_ = std::max(dense_below_, 4 * (size_ + more) + 1024); }

  /// False where the id is there already; it then stays as it was. Ids are not negative.
  bool add(Index id, Index position) {
    if (position_of(id) != nullptr) return false;
    ++size_;
    if (id >= dense_below_) return rest_.emplace(id, position).second;
    if (std::size_t(id) >= dense_.size())
      dense_.resize(std::max({std::size_t(id) + 1, 3 * dense_.size() / 2, std::size_t(16)}), absent);
    dense_[std::size_t(id)] = position;
    return true;
  }

  /// Null where there is no such id.
  const Index* position_of(Index id) const {
    if (id >= 0 && id < Index(dense_.size()) && dense_[std::size_t(id)] != absent)
      return &dense_[std::size_t(id)];
    if (rest_.empty()) return nullptr;
    const auto found = rest_.find(id);
    return found == rest_.end() ? nullptr : &found->second;
  }

  /// Begins to bring what add() of the id will look at.
  ALWAYS_INLINE void fetch(Index id) const {
    if (id >= 0 && id < Index(dense_.size())) bondstatic::fetch(&dense_[std::size_t(id)]);
  }

  Index size() const { return size_; }

 private:
  static constexpr Index absent = -1;

  std::vector<Index> dense_;
  std::unordered_map<Index, Index> rest_;
  Index dense_below_ = 1024;
  Index size_ = 0;
};

}  // namespace bondstatic
