#include "model/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace bondstatic {
namespace {

using Cell = std::array<Index, 3>;

/// Spheres of one size class (largest reach at most twice the smallest) in cells at least as wide as the
/// largest sphere; cells are found by hash, and the spheres of one hash value stand together.
class Grid {
 public:
  Grid(std::span<const Vector3> positions, std::vector<Index> members, const Vector3& corner,
       double cell_size)
      : corner_(corner), cell_size_(cell_size), mask_(std::bit_ceil(members.size()) - 1), first_(mask_ + 2) {
    std::vector<std::size_t> bucket;
    std::vector<Cell> cells;
    for (const Index member : members) {
      cells.push_back(cell_of(positions[std::size_t(member)]));
      bucket.push_back(hash(cells.back()));
      ++first_[bucket.back() + 1];
    }
    for (std::size_t b = 0; b <= mask_; ++b) first_[b + 1] += first_[b];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    members_.resize(members.size());
    cells_.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::size_t slot = next[bucket[i]]++;
      members_[slot] = members[i];
      cells_[slot] = cells[i];
    }
  }

  /// Calls visit(member) for all spheres whose cell meets the box of half width `reach` about `point`.
  template <class Visit>
  void visit_near(const Vector3& point, double reach, Visit&& visit) const {
    const Cell low = cell_of(point - Vector3::Constant(reach)),
               high = cell_of(point + Vector3::Constant(reach));
    Cell cell;
    for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
          const std::size_t bucket = hash(cell);
          for (std::size_t slot = first_[bucket]; slot < first_[bucket + 1]; ++slot)
            if (cells_[slot] == cell) visit(members_[slot]);
        }
  }

  double cell_size() const { return cell_size_; }

 private:
  Cell cell_of(const Vector3& point) const {
    const Vector3 scaled = (point - corner_) / cell_size_;
    return {Index(std::floor(scaled[0])), Index(std::floor(scaled[1])), Index(std::floor(scaled[2]))};
  }

  std::size_t hash(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const Index c : cell) {
      h = (h ^ std::uint64_t(c)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return std::size_t(h) & mask_;
  }

  Vector3 corner_;
  double cell_size_;
  std::size_t mask_;
  std::vector<std::size_t> first_;  ///< of a hash value's spheres in members_
  std::vector<Index> members_;
  std::vector<Cell> cells_;
};

/// Pairs sorted by (i, j) in linear time: counted by i, then each particle's few partners sorted.
std::vector<std::pair<Index, Index>> sorted(std::vector<std::pair<Index, Index>> pairs, std::size_t count) {
  std::vector<std::size_t> first(count + 1);
  for (const auto& pair : pairs) ++first[std::size_t(pair.first) + 1];
  for (std::size_t i = 0; i < count; ++i) first[i + 1] += first[i];
  std::vector<std::size_t> next = first;
  std::vector<std::pair<Index, Index>> out(pairs.size());
  for (const auto& pair : pairs) out[next[std::size_t(pair.first)]++] = pair;
  for (std::size_t i = 0; i < count; ++i)
    std::sort(out.begin() + std::ptrdiff_t(first[i]), out.begin() + std::ptrdiff_t(first[i + 1]));
  return out;
}

}  // namespace

std::vector<std::pair<Index, Index>> touching_pairs(std::span<const Vector3> positions,
                                                    std::span<const double> reach) {
  const std::size_t count = positions.size();
  if (count == 0) return {};
  Vector3 low = positions[0], high = positions[0];
  for (const Vector3& x : positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  // Cells much smaller than the extent would overflow their numbers; larger ones are only slower.
  const double smallest_cell =
      std::max((high - low).maxCoeff() * 0x1p-40, std::numeric_limits<double>::min());

  // Size class k holds the spheres whose reach lies in [2^k, 2^(k+1)).
  const auto size_class = [&](std::size_t i) { return std::ilogb(std::max(reach[i], smallest_cell / 4)); };
  std::map<int, std::vector<Index>> classes;
  for (std::size_t i = 0; i < count; ++i) classes[size_class(i)].push_back(Index(i));
  std::map<int, Grid> grids;
  for (const auto& [k, members] : classes)
    grids.emplace(k, Grid(positions, members, low, std::ldexp(1.0, k + 2)));

  // Each sphere looks for partners of its own size and larger: a large one has many small neighbours, but a
  // small one touches few large ones unless they overlap.
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& [k, members] : classes)
    for (auto grid = grids.find(k); grid != grids.end(); ++grid)
      for (const Index i : members) {
        const Vector3& x = positions[std::size_t(i)];
        const double r = reach[std::size_t(i)];
        grid->second.visit_near(x, r + grid->second.cell_size() / 2, [&](Index j) {
          if (grid->first == k && j <= i) return;
          const double sum = r + reach[std::size_t(j)];
          if ((positions[std::size_t(j)] - x).squaredNorm() <= sum * sum)
            pairs.push_back(std::minmax({i, j}));
        });
      }
  return sorted(std::move(pairs), count);
}

}  // namespace bondstatic
