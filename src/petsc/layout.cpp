#include "petsc/layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "system/bisection.hpp"

namespace bondstatic {

Layout lay_out(std::span<const Vector3> positions, const FreeDofs& dofs, int ranks) {
  std::vector<Index> moving;
  std::vector<Vector3> points;
  for (std::size_t p = 0; p < positions.size(); ++p) {
    if (dofs.first[p + 1] == dofs.first[p]) continue;
    moving.push_back(Index(p));
    points.push_back(positions[p]);
  }
  const std::vector<int> part = bisect(points, ranks);
  Layout layout;
  layout.first.assign(std::size_t(ranks) + 1, 0);
  for (const int r : part) ++layout.first[std::size_t(r) + 1];
  for (std::size_t r = 0; r < std::size_t(ranks); ++r) layout.first[r + 1] += layout.first[r];
  layout.body.resize(moving.size());
  layout.row.assign(positions.size(), -1);
  std::vector<Index> next(layout.first.begin(), layout.first.end() - 1);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Index row = next[std::size_t(part[i])]++;
    layout.body[std::size_t(row)] = moving[i];
    layout.row[std::size_t(moving[i])] = row;
  }
  return layout;
}

BlockCount count_blocks(const BondNetwork& network, const Incidence& incidence, const Layout& layout,
                        int rank, Index body) {
  std::vector<Index> rows{layout.row[std::size_t(body)]};
  for (const Index k : incidence.of(body)) {
    const Link& link = network.links[std::size_t(k)];
    const Index row = layout.row[std::size_t(link.a == body ? link.b : link.a)];
    if (row >= 0) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  const Index begin = layout.first[std::size_t(rank)], end = layout.first[std::size_t(rank) + 1];
  const auto own =
      std::count_if(rows.begin(), rows.end(), [=](Index row) { return begin <= row && row < end; });
  return {Index(own), Index(rows.size())};
}

void check_index_range(Index block_rows, Index blocks_on_a_rank, Index largest) {
  const char* cure =
      "use the solver cholmod or multigrid, or build with PETSc of 64-bit integers (petsc64-dev)";
  if (block_rows > largest / 6)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("{} particles have more unknowns than the integers of this PETSc can count (at most "
                    "{})\n    cure: {}",
                    block_rows, largest, cure));
  if (blocks_on_a_rank > largest / 36)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("the matrix has 36 x {} entries on one rank, more than the integers of this PETSc can "
                    "count (at most {})\n    cure: start more ranks, or {}",
                    blocks_on_a_rank, largest, cure));
}

}  // namespace bondstatic
