#include "petsc/layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

// Six bodies in a row along x, each linked to the next; the third has nothing free.
struct Row {
  BondNetwork network;
  FreeDofs dofs = number_free_dofs({0x3f, 0x3f, 0, 0x01, 0x3f, 0x3f});
  std::vector<Vector3> positions;

  Row() {
    network.bodies = 6;
    for (Index p = 0; p < 6; ++p) positions.emplace_back(double(p), 0, 0);
    for (Index p = 0; p < 5; ++p) network.links.push_back({p, p + 1, Vector3::UnitX(), 0.5, {1, 1, 1, 1, 0}});
  }
};

TEST(Layout, GivesRowsToBodiesThatMayMoveRankByRank) {
  const Row row;
  const Layout layout = lay_out(row.positions, row.dofs, 2);
  EXPECT_EQ(layout.body, (std::vector<Index>{0, 1, 3, 4, 5}));
  EXPECT_EQ(layout.row, (std::vector<Index>{0, 1, -1, 2, 3, 4}));
  EXPECT_EQ(layout.first, (std::vector<Index>{0, 2, 5}));
}

TEST(Layout, CountsBlocksOfTheRankAndInAll) {
  const Row row;
  const Incidence incidence = link_incidence(row.network);
  const Layout layout = lay_out(row.positions, row.dofs, 5);
  const BlockCount at_first = count_blocks(row.network, incidence, layout, 0, 0);
  EXPECT_EQ(at_first.own, 1);  // the neighbour is on the next rank
  EXPECT_EQ(at_first.all, 2);
  const BlockCount beside_held = count_blocks(row.network, incidence, layout, 1, 1);
  EXPECT_EQ(beside_held.all, 2);  // the held one has no column
}

TEST(Layout, RefusesWhatPetscsIntegersCannotCount) {
  constexpr Index largest = 2'147'483'647;
  EXPECT_NO_THROW(check_index_range(357'913'941, 59'652'323, largest));
  for (const auto& [rows, blocks] : {std::pair<Index, Index>{357'913'942, 1}, {1, 59'652'324}}) {
    try {
      check_index_range(rows, blocks, largest);
      FAIL() << "took " << rows << " rows, " << blocks << " blocks";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), testing::HasSubstr("petsc64-dev"));
    }
  }
}

}  // namespace
}  // namespace bondstatic
