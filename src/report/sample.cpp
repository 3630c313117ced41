#include "report/sample.hpp"

#include <algorithm>
#include <utility>

#include "bondstatic/error.hpp"
#include "io/id_table.hpp"

namespace bondstatic {

namespace {

using Of = Grid::Of;

/// SplitMix64 (Steele, Lea, Flood 2014): different ids have different numbers.
std::uint64_t scattered(Index id) {
  std::uint64_t x = std::uint64_t(id) + 0x9e3779b97f4a7c15;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

std::vector<Index> ids_of(const Grid& grid, Of of) {
  std::vector<Index> ids = grid.whole_numbers(of, "id");
  if (std::any_of(ids.begin(), ids.end(), [](Index id) { return id < 0; }))
    throw InputError({{{grid.path()}, "is damaged: an id is negative", "solve the case again"}});
  return ids;
}

/// Places of the `most` items that come first by their ids' numbers, in that order.
template <class Counts>
std::vector<Index> first_by_number(const std::vector<Index>& ids, Index most, Counts counts) {
  std::vector<std::pair<std::uint64_t, Index>> order;
  for (Index i = 0; i < Index(ids.size()); ++i)
    if (counts(i)) order.emplace_back(scattered(ids[std::size_t(i)]), i);
  const auto end = order.begin() + std::min(most, Index(order.size()));
  std::nth_element(order.begin(), end, order.end());
  std::sort(order.begin(), end);
  std::vector<Index> places;
  for (auto one = order.begin(); one != end; ++one) places.push_back(one->second);
  return places;
}

/// Of each point: itself, or the original that it is in place of.
std::vector<Index> originals(const std::vector<Index>& ids, const std::vector<bool>& copies,
                             const std::vector<double>& positions) {
  IdTable point_of;
  point_of.expect(Index(ids.size()));
  for (std::size_t p = 0; p < ids.size(); ++p)
    if (!copies[p]) point_of.add(ids[p], Index(p));
  std::vector<Index> originals(ids.size());
  for (std::size_t p = 0; p < ids.size(); ++p) {
    originals[p] = Index(p);
    const Index* own = copies[p] ? point_of.position_of(ids[p]) : nullptr;
    if (own && std::equal(&positions[3 * p], &positions[3 * p] + 3, &positions[3 * std::size_t(*own)]))
      originals[p] = *own;
  }
  return originals;
}

}  // namespace

Sample take_sample(const Grid& grid, Index particles, Index bonds) {
  const std::vector<Index> ids = ids_of(grid, Of::points);
  const std::vector<bool> copies = grid.copies();
  Sample sample;
  sample.all_particles = std::count(copies.begin(), copies.end(), false);
  sample.all_bonds = grid.count(Of::lines);
  sample.points = first_by_number(ids, particles, [&](Index p) { return !copies[std::size_t(p)]; });
  sample.drawn = Index(sample.points.size());
  sample.lines = first_by_number(ids_of(grid, Of::lines), bonds, [](Index) { return true; });

  const std::vector<Index> original = originals(ids, copies, grid.positions()), ends = grid.ends();
  std::vector<Index> row(ids.size(), -1);
  for (std::size_t r = 0; r < sample.points.size(); ++r) row[std::size_t(sample.points[r])] = Index(r);
  const auto row_of = [&](Index point) {
    const Index p = original[std::size_t(point)];
    Index& found = row[std::size_t(p)];
    if (found < 0) {
      found = Index(sample.points.size());
      sample.points.push_back(p);
    }
    return std::uint32_t(found);
  };
  for (const Index line : sample.lines) {
    sample.a.push_back(row_of(ends[std::size_t(2 * line)]));
    sample.b.push_back(row_of(ends[std::size_t(2 * line + 1)]));
  }
  return sample;
}

}  // namespace bondstatic
