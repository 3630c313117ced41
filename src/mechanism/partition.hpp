// Disjoint sets of 0 ... n-1 under union (union-find with path halving and union by size).
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

class Partition {
 public:
  explicit Partition(Index count) : parent_(std::size_t(count)), size_(std::size_t(count), 1) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
  }

  /// The member that stands for the set of i.
  Index find(Index i) {
    while (parent_[std::size_t(i)] != i) {
      Index& up = parent_[std::size_t(i)];
      up = parent_[std::size_t(up)];
      i = up;
    }
    return i;
  }

  /// False where the two were in one set already.
  bool unite(Index i, Index j) {
    i = find(i), j = find(j);
    if (i == j) return false;
    if (size_[std::size_t(i)] < size_[std::size_t(j)]) std::swap(i, j);
    parent_[std::size_t(j)] = i;
    size_[std::size_t(i)] += size_[std::size_t(j)];
    return true;
  }

  Index count() const { return Index(parent_.size()); }

  /// The sets, each ascending, in the order of their first members; only of those that `wanted` takes.
  template <class Wanted>
  std::vector<std::vector<Index>> members(Wanted wanted) {
    std::vector<std::vector<Index>> sets;
    std::vector<Index> number(parent_.size(), -1);
    for (Index i = 0; i < count(); ++i) {
      if (!wanted(i)) continue;
      Index& set = number[std::size_t(find(i))];
      if (set < 0) set = Index(sets.size()), sets.emplace_back();
      sets[std::size_t(set)].push_back(i);
    }
    return sets;
  }

 private:
  std::vector<Index> parent_;
  std::vector<Index> size_;
};

}  // namespace bondstatic
