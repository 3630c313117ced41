#include "petsc/layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

Index width(const FreeDofs& dofs, Index body) {
  return dofs.first[std::size_t(body) + 1] - dofs.first[std::size_t(body)];
}

// Once each, ascending.
std::vector<Index> moving_neighbours(const BondNetwork& network, const Incidence& incidence,
                                     const FreeDofs& dofs, Index body) {
  std::vector<Index> neighbours;
  for (const Index k : incidence.of(body)) {
    const Link& link = network.links[std::size_t(k)];
    const Index other = link.a == body ? link.b : link.a;
    if (width(dofs, other) > 0) neighbours.push_back(other);
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return neighbours;
}

}  // namespace

Index count_rows(const BondNetwork& network, const FreeDofs& dofs) {
  Index rows = 0;
  for (Index p = 0; p < network.own(); ++p) rows += width(dofs, p) > 0;
  return rows;
}

Layout lay_out(const BondNetwork& network, const FreeDofs& dofs, Index first) {
  Layout layout;
  layout.row.assign(std::size_t(network.bodies), -1);
  layout.body.reserve(std::size_t(count_rows(network, dofs)));
  for (Index p = 0; p < network.own(); ++p) {
    if (width(dofs, p) == 0) continue;
    layout.row[std::size_t(p)] = first + Index(layout.body.size());
    layout.body.push_back(p);
  }
  return layout;
}

BlockCount count_blocks(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                        Index body) {
  BlockCount count{1, 1};
  for (const Index other : moving_neighbours(network, incidence, dofs, body)) {
    ++count.all;
    if (other < network.own()) ++count.own;
  }
  return count;
}

Index twice_the_entries(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                        Index body) {
  Index across = width(dofs, body) + 1;
  for (const Index other : moving_neighbours(network, incidence, dofs, body)) across += width(dofs, other);
  return width(dofs, body) * across;
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
