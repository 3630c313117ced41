#include "petsc/layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

// Six bodies in a row along x, each linked to the next, the first two twice; the third has nothing free, the
// fourth one unknown.
struct Row {
  BondNetwork network;
  NetworkShare share;
  FreeDofs dofs = number_free_dofs({0x3f, 0x3f, 0, 0x01, 0x3f, 0x3f});

  Row() {
    network.bodies = 6;
    for (Index p = 0; p < 5; ++p) network.links.push_back({p, p + 1, Vector3::UnitX(), 0.5, {1, 1, 1, 1, 0}});
    network.links.push_back({1, 0, -Vector3::UnitX(), 0.5, {1, 1, 1, 1, 0}});
  }
  void own(Index bodies) {
    share.own = bodies;
    network.share = &share;
  }
};

TEST(Layout, GivesRowsToBodiesThatMayMove) {
  const Row row;
  const Layout layout = lay_out(row.network, row.dofs, 0);
  EXPECT_EQ(layout.body, (std::vector<Index>{0, 1, 3, 4, 5}));
  EXPECT_EQ(layout.row, (std::vector<Index>{0, 1, -1, 2, 3, 4}));
  EXPECT_EQ(count_rows(row.network, row.dofs), 5);
}

TEST(Layout, GivesRowsToOwnBodiesBehindThoseOfLowerRanks) {
  Row row;
  row.own(4);
  const Layout layout = lay_out(row.network, row.dofs, 10'000'000'000);
  EXPECT_EQ(layout.body, (std::vector<Index>{0, 1, 3}));
  EXPECT_EQ(layout.row, (std::vector<Index>{10'000'000'000, 10'000'000'001, -1, 10'000'000'002, -1, -1}));
  EXPECT_EQ(count_rows(row.network, row.dofs), 3);
}

TEST(Layout, CountsBlocksOfTheRankAndInAll) {
  Row row;
  const Incidence incidence = link_incidence(row.network);
  row.own(4);
  const auto blocks = [&](Index body) {
    const BlockCount count = count_blocks(row.network, incidence, row.dofs, body);
    return std::pair(count.own, count.all);
  };
  EXPECT_EQ(blocks(0), std::pair(Index(2), Index(2)));  // two links, one neighbour
  EXPECT_EQ(blocks(1), std::pair(Index(2), Index(2)));  // the held one has no column
  EXPECT_EQ(blocks(3), std::pair(Index(1), Index(2)));  // one neighbour is held, one is on another rank
}

// Diagonal blocks 4 x 21 + 1, between bodies 36 + 6 + 36.
TEST(Layout, EntriesOfAllBodiesAreThoseOfTheLowerTriangle) {
  const Row row;
  const Incidence incidence = link_incidence(row.network);
  Index twice = 0;
  for (Index p = 0; p < 6; ++p) twice += twice_the_entries(row.network, incidence, row.dofs, p);
  EXPECT_EQ(twice, 2 * (4 * 21 + 1 + 36 + 6 + 36));
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
