#include "system/level_elimination.hpp"

#include <gtest/gtest.h>

namespace bondstatic::test {
namespace {

Link bond(Index a, Index b) {
  Link link;
  link.a = a;
  link.b = b;
  return link;
}

// `width` strands of `length` bodies, each bonded to the next in its strand, all of a layer to each other.
BondNetwork ladder(Index width, Index length) {
  BondNetwork network;
  network.bodies = width * length;
  for (Index layer = 0; layer < length; ++layer)
    for (Index i = 0; i < width; ++i) {
      const Index p = layer * width + i;
      for (Index j = i + 1; j < width; ++j) network.links.push_back(bond(p, layer * width + j));
      if (layer + 1 < length) network.links.push_back(bond(p, p + width));
    }
  return network;
}

double flops(const BondNetwork& network, double enough = 1e30) {
  std::vector<std::uint8_t> free(std::size_t(network.bodies), 0x3f);
  return level_elimination_flops(network, link_incidence(network), number_free_dofs(free), enough);
}

TEST(LevelElimination, OfAChainIsABodyAtATime) {
  EXPECT_DOUBLE_EQ(flops(ladder(1, 100)), 99 * 216 * (1.0 / 3 + 2) + 216 / 3.0);
}

TEST(LevelElimination, GrowsWithTheCubeOfTheWidth) {
  const double ratio = flops(ladder(20, 200)) / flops(ladder(10, 200));
  EXPECT_GT(ratio, 7);
  EXPECT_LT(ratio, 9);
}

TEST(LevelElimination, StopsCountingWhereItIsEnough) {
  const BondNetwork network = ladder(10, 500);
  EXPECT_LT(flops(network, 1e6), 1e7);
  EXPECT_GE(flops(network, 1e6), 1e6);
}

TEST(LevelElimination, LeavesOutWhatIsHeld) {
  const BondNetwork network = ladder(1, 10);
  std::vector<std::uint8_t> free(10, 0x3f);
  free[5] = 0;  // two chains, of five and of four
  EXPECT_DOUBLE_EQ(level_elimination_flops(network, link_incidence(network), number_free_dofs(free), 1e30),
                   flops(ladder(1, 5)) + flops(ladder(1, 4)));
}

}  // namespace
}  // namespace bondstatic::test
