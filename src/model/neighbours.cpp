#include "model/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace bondstatic {
namespace {

using Cell = std::array<Index, 3>;

/// Spheres of one size class (largest reach at most twice the smallest) in cells as wide as the largest of
/// them. Cells are found by hash; what has one hash value stands together, and so do cells near each other.
class Grid {
 public:
  struct Sphere {
    Vector3 position;
    double reach;
    Index number;
    Cell cell;
  };

  Grid(std::span<const Vector3> positions, std::span<const double> reach, const std::vector<Index>& members,
       const Vector3& corner, double smallest_cell)
      : corner_(corner),
        mask_(std::bit_ceil(std::max<std::size_t>(members.size(), 64)) - 1),
        first_(mask_ + 2) {
    for (const Index member : members) largest_ = std::max(largest_, reach[std::size_t(member)]);
    cell_size_ = std::max(2 * largest_, smallest_cell);
    for (const Index member : members) ++first_[hash(cell_of(positions[std::size_t(member)])) + 1];
    for (std::size_t b = 0; b <= mask_; ++b) first_[b + 1] += first_[b];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    spheres_.resize(members.size());
    for (const Index member : members) {
      const Vector3& x = positions[std::size_t(member)];
      const Cell cell = cell_of(x);
      spheres_[next[hash(cell)]++] = {x, reach[std::size_t(member)], member, cell};
    }
  }

  /// In an order in which neighbours come soon after each other, for the processor's cache.
  const std::vector<Sphere>& spheres() const { return spheres_; }

  /// Calls visit(sphere) for all that may touch a sphere of that reach about `point`.
  template <class Visit>
  void visit_near(const Vector3& point, double reach, Visit&& visit) const {
    // A little wider, so that rounding cannot put what touches in one point outside.
    const Vector3 half_width = Vector3::Constant((reach + largest_) * (1 + 1e-12));
    const Cell low = cell_of(point - half_width), high = cell_of(point + half_width);
    Cell cell;
    for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
          const std::size_t bucket = hash(cell);
          for (std::size_t slot = first_[bucket]; slot < first_[bucket + 1]; ++slot)
            if (spheres_[slot].cell == cell) visit(spheres_[slot]);
        }
  }

 private:
  Cell cell_of(const Vector3& point) const {
    const Vector3 scaled = (point - corner_) / cell_size_;
    return {Index(std::floor(scaled[0])), Index(std::floor(scaled[1])), Index(std::floor(scaled[2]))};
  }

  /// Blocks of 4 x 4 x 4 cells are scattered, the cells of a block stay together.
  std::size_t hash(const Cell& cell) const {
    std::uint64_t h = 0, within = 0;
    for (const Index c : cell) {
      h = (h ^ std::uint64_t(c >> 2)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
      within = within << 2 | std::uint64_t(c & 3);
    }
    return std::size_t(h << 6 | within) & mask_;
  }

  Vector3 corner_;
  double largest_ = 0;
  double cell_size_ = 0;
  std::size_t mask_;
  std::vector<std::size_t> first_;  ///< of a hash value's spheres
  std::vector<Sphere> spheres_;
};

using Pairs = std::vector<std::pair<Index, Index>>;

constexpr Index piece_size = 1 << 12;  // spheres that one thread takes at a time

Index pieces_of(Index count) {
  return (count + piece_size - 1) / piece_size;
}

int threads_for(Index pieces, int threads) {
  return int(std::clamp<Index>(pieces, 1, std::max(1, threads)));
}

/// Pairs sorted by (i, j) in linear time: counted by i, then each particle's few partners sorted.
Pairs sorted(std::vector<Pairs> found, Index count, int threads) {
  std::vector<std::size_t> next(std::size_t(count) + 1);
  for (const Pairs& pairs : found)
    for (const auto& pair : pairs) ++next[std::size_t(pair.first) + 1];
  for (std::size_t i = 0; i < std::size_t(count); ++i) next[i + 1] += next[i];
  Pairs out(next.back());
  for (Pairs& pairs : found) {
    for (const auto& pair : pairs) out[next[std::size_t(pair.first)]++] = pair;
    Pairs().swap(pairs);
  }
  // By now next[i] is where the partners of i end.
  const Index pieces = pieces_of(count);
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(pieces, threads)) if (threads > 1)
  for (Index piece = 0; piece < pieces; ++piece)
    for (Index i = piece * piece_size; i < std::min(count, (piece + 1) * piece_size); ++i) {
      const std::size_t begin = i == 0 ? 0 : next[std::size_t(i) - 1];
      std::sort(out.begin() + std::ptrdiff_t(begin), out.begin() + std::ptrdiff_t(next[std::size_t(i)]));
    }
  return out;
}

/// Pairs of the spheres of `own` with those of `other`, in pieces of `own`.
void append_touching(const Grid& own, const Grid& other, int threads, std::vector<Pairs>& found) {
  const auto& spheres = own.spheres();
  const Index count = Index(spheres.size()), pieces = pieces_of(count);
  const std::size_t before = found.size();
  found.resize(before + std::size_t(pieces));
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(pieces, threads)) if (threads > 1)
  for (Index piece = 0; piece < pieces; ++piece) {
    Pairs pairs;
    for (Index i = piece * piece_size; i < std::min(count, (piece + 1) * piece_size); ++i) {
      const Grid::Sphere& s = spheres[std::size_t(i)];
      other.visit_near(s.position, s.reach, [&](const Grid::Sphere& t) {
        if (&own == &other && t.number <= s.number) return;
        const double sum = s.reach + t.reach;
        if ((t.position - s.position).squaredNorm() <= sum * sum)
          pairs.push_back(std::minmax(s.number, t.number));
      });
    }
    found[before + std::size_t(piece)] = std::move(pairs);
  }
}

}  // namespace

std::vector<std::pair<Index, Index>> touching_pairs(std::span<const Vector3> positions,
                                                    std::span<const double> reach, int threads) {
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
    grids.emplace(k, Grid(positions, reach, members, low, smallest_cell));

  // Each sphere looks for partners of its own size and larger: a large one has many small neighbours, but a
  // small one touches few large ones unless they overlap.
  std::vector<Pairs> found;
  for (auto own = grids.begin(); own != grids.end(); ++own)
    for (auto other = own; other != grids.end(); ++other)
      append_touching(own->second, other->second, threads, found);
  grids.clear();
  return sorted(std::move(found), Index(count), threads);
}

}  // namespace bondstatic
