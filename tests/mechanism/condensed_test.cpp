// A network cut into pieces, each condensed and all put together, against the whole. BONDSTATIC_FULL=1 runs
// ten times as many.
#include "mechanism/condensed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "mechanism/pieces.hpp"
#include "mechanism/random_models.hpp"
#include "system/bisection.hpp"

namespace bondstatic {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Condensed condensed(const NetPiece& piece) {
  return condense(piece.network, piece.dofs, piece.model, piece.number);
}

Condensed sent(const Condensed& condensed) {
  const ArchiveFormat format{"test", 1};
  Archive to(format);
  to(condensed);
  const std::string bytes = to.finish();
  Archive from(format, bytes, "test");
  Condensed received;
  from(received);
  from.expect_end();
  return received;
}

Assembled assembled(const std::vector<NetPiece>& pieces) {
  std::vector<Condensed> all;
  for (const NetPiece& piece : pieces) all.push_back(sent(condensed(piece)));
  return assemble_condensed(all);
}

std::vector<int> by_place(const Net& net, int ranks) {
  std::vector<Vector3> places;
  for (const Particle& p : net.model.particles) places.push_back(p.position);
  return bisect(places, ranks);
}

// Compact parts, stripes of numbers, or any particle anywhere, so that ranks own what only others connect.
std::vector<int> random_cut(Random& random, const Net& net, int ranks) {
  const Index way = pick(random, 3);
  if (way == 0) return by_place(net, ranks);
  const Index stripe = 1 + pick(random, 5);
  std::vector<int> rank_of;
  for (Index p = 0; p < net.count(); ++p)
    rank_of.push_back(way == 1 ? int(p / stripe % ranks) : int(pick(random, ranks)));
  return rank_of;
}

using Groups = std::vector<std::vector<Index>>;

Groups numbers_of(const Assembled& all, Groups groups) {
  for (auto& group : groups)
    for (Index& p : group) p = all.number[std::size_t(p)];
  return groups;
}

// Groups of condensed bodies as groups of all bodies, each ascending, in the order of their first bodies.
Groups spread_over(const std::vector<NetPiece>& pieces, const Groups& groups) {
  Groups found(groups.size());
  std::map<Index, Index> group_of;
  for (const NetPiece& piece : pieces) {
    const auto group = spread(piece.network, piece.model, piece.number, groups);
    for (std::size_t p = 0; p < group.size(); ++p) {
      const auto [known, added] = group_of.try_emplace(piece.number[p], group[p]);
      EXPECT_EQ(known->second, group[p]) << "a copy of " << piece.number[p] << " is told otherwise";
      if (Index(p) < piece.share.own && group[p] >= 0)
        found[std::size_t(group[p])].push_back(piece.number[p]);
    }
  }
  for (auto& group : found) std::sort(group.begin(), group.end());
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> all_moving(const std::vector<Mechanism>& mechanisms) {
  std::set<Index> moving;
  for (const Mechanism& m : mechanisms) moving.insert(m.particles.begin(), m.particles.end());
  return {moving.begin(), moving.end()};
}

void expect_same_mechanisms(const Net& net, const Assembled& all, const std::vector<NetPiece>& pieces,
                            const Groups& left_out) {
  std::vector<bool> out(std::size_t(net.count()), false), out_condensed(all.number.size(), false);
  for (const auto& group : left_out)
    for (const Index p : group) out[std::size_t(p)] = true;
  for (std::size_t p = 0; p < out_condensed.size(); ++p) out_condensed[p] = out[std::size_t(all.number[p])];
  const auto expected = net.mechanisms(out);
  const auto found = find_mechanisms(all.model, all.network, all.dofs, out_condensed);
  EXPECT_EQ(found.empty(), expected.empty());
  EXPECT_EQ(motions_in_all(found), motions_in_all(expected));
  EXPECT_EQ(spread_over(pieces, numbers_of(all, {all_moving(found)})), Groups{all_moving(expected)});
}

// Everything that is asked of the condensed network; the number of free motions of the whole.
Index expect_same(const Net& net, const std::vector<int>& rank_of, int ranks) {
  const std::vector<NetPiece> pieces = cut(net, rank_of, ranks);
  const Assembled all = assembled(pieces);
  const Groups unsupported = unsupported_bodies(net.network, net.dofs());
  EXPECT_EQ(spread_over(pieces, numbers_of(all, unsupported_bodies(all.network, all.dofs))), unsupported);
  expect_same_mechanisms(net, all, pieces, {});
  expect_same_mechanisms(net, all, pieces, unsupported);
  return motions_in_all(net.mechanisms());
}

class CondensedNetwork : public ::testing::TestWithParam<int> {
 protected:
  int ranks_ = 1 + GetParam() % 4;
  int models_ = full_run() ? 200 : 20;
  std::uint64_t seed(int m) const { return 400000 + std::uint64_t(GetParam()) * 1000 + std::uint64_t(m); }

  // Builds a model from its random numbers, over and over; the numbers of sound and of all models.
  template <class Make>
  std::pair<int, int> compare(Make make) {
    int sound = 0;
    for (int m = 0; m < models_; ++m) {
      SCOPED_TRACE(testing::Message() << "seed " << seed(m) << ", ranks " << ranks_);
      Random random(seed(m));
      const Net net = make(random, m);
      sound += expect_same(net, random_cut(random, net, ranks_), ranks_) == 0;
    }
    return {sound, models_};
  }
};

TEST_P(CondensedNetwork, MovesAsTheWholeDoes) {
  const auto [sound, models] = compare([](Random& random, int) { return random_network(random, 40); });
  EXPECT_LT(sound, models);
}

// Bonds that leave the box on one side and come back on the other; a particle may meet its own image.
void bond_round_the_cell(Random& random, Net& net) {
  Vector3 low = net.at(0), high = low;
  for (Index p = 0; p < net.count(); ++p) low = low.cwiseMin(net.at(p)), high = high.cwiseMax(net.at(p));
  const Vector3 cell = (high - low).array() + 0.7;
  const double welded = uniform(random);
  for (int axis = 0; axis < 3; ++axis)
    for (Index a = 0; a < net.count(); ++a)
      for (Index b = 0; b < net.count(); ++b) {
        const Vector3 branch = net.at(b) - net.at(a) + cell[axis] * Vector3::Unit(axis);
        if (branch.norm() < 1.3)
          net.network.links.push_back({a, b, branch, 0.5, uniform(random) < welded ? beam : contact});
      }
}

TEST_P(CondensedNetwork, MovesAsTheWholeDoesInAPeriodicCell) {
  const auto [sound, models] = compare([](Random& random, int) {
    Net net = random_network(random, 40);
    bond_round_the_cell(random, net);
    return net;
  });
  EXPECT_LT(sound, models);
}

// Clumps of beams in a lattice whose other bonds are hinges, from none to all of them; rattlers beside it.
TEST_P(CondensedNetwork, MovesAsTheWholeDoesWhateverTheShareOfHinges) {
  const auto [sound, models] = compare([&](Random& random, int m) {
    Net net;
    const Index side = 5;
    for (Index p = 0; p < side * side * side; ++p)
      net.particle(Vector3(double(p % side), double(p / side % side), double(p / (side * side))) +
                   0.1 * direction(random));
    const double hinged = double(m) / double(models_ - 1);
    const SectionStiffness hinge = m % 3 ? contact : frictionless;
    bond_neighbours(net, 1.3,
                    [&](Index a, Index b) { net.bond(a, b, uniform(random) < hinged ? hinge : beam); });
    for (Index p = 0; p < side * side; ++p)
      if (m % 2 || p == 12) net.hold(p, m % 5 ? "xyzuvw" : "xyz");
    for (Index rattlers = pick(random, 8) - 4; rattlers > 0; --rattlers) net.particle(20 * direction(random));
    return net;
  });
  EXPECT_GT(sound, 0);
  EXPECT_LT(sound, models);
}

TEST_P(CondensedNetwork, ShowsPlantedDefectsAndNoneElse) {
  const auto [sound, models] = compare([](Random& random, int m) {
    Sound model = sound_model(random);
    if (m % 2)
      plant(random, model, Defect(m / 2 % defects));
    else
      hold_well(random, model.net);
    return model.net;
  });
  EXPECT_EQ(sound, (models + 1) / 2);
}

INSTANTIATE_TEST_SUITE_P(Mechanism, CondensedNetwork, ::testing::Range(0, 8));

TEST(Condensed, BodiesMayHangTogetherOnlyThroughOtherRanks) {
  // Of a chain of ten the first rank owns both ends, the second what is between them, the third nothing.
  Net net;
  chain(net, {0, 0, 0}, {1, 0.2, 0}, 10);
  const std::vector<int> rank_of{0, 0, 1, 1, 1, 1, 1, 0, 0, 0};
  EXPECT_EQ(expect_same(net, rank_of, 3), 6);
  net.hold(0, "xyz");
  EXPECT_EQ(expect_same(net, rank_of, 3), 3);
  net.hold(9, "yz");
  EXPECT_EQ(expect_same(net, rank_of, 3), 1);
  net.hold(4, "u");
  EXPECT_EQ(expect_same(net, rank_of, 3), 0);
  net.network.links[4].stiffness.kt = 0;
  EXPECT_EQ(expect_same(net, rank_of, 3), 1);
}

TEST(Condensed, SetThatNothingElseNamesStaysByItsEnds) {
  Net net;
  chain(net, {0, 0, 0}, {1, 0, 0}, 7);
  const auto held = chain(net, {0, 9, 0}, {1, 0, 0}, 5);
  net.hold(held[2]);
  net.particle({0, 20, 0});
  const std::vector<NetPiece> pieces = cut(net, std::vector<int>(13, 0), 1);
  EXPECT_THAT(condensed(pieces[0]).number, ElementsAre(0, 6, 7, 9, 12));
  const Assembled all = assembled(pieces);
  EXPECT_THAT(numbers_of(all, unsupported_bodies(all.network, all.dofs)),
              ElementsAre(ElementsAre(0, 6), ElementsAre(12)));
  EXPECT_THAT(spread(pieces[0].network, net.model, pieces[0].number, Groups{{12}, {0, 6}}),
              ElementsAre(1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, 0));
}

TEST(Condensed, OfAWholeNetworkNeedsNoShare) {
  Net net;
  const auto bar = chain(net, {0, 0, 0}, {1, 0, 0}, 100);
  net.hold(bar[50], "xyzuv");
  std::vector<Index> number;
  for (Index p = 0; p < net.count(); ++p) number.push_back(1000 + 3 * p);
  const Assembled all = assemble_condensed(std::vector{condense(net.network, net.dofs(), net.model, number)});
  EXPECT_THAT(all.number, ElementsAre(1000, 1150));
  EXPECT_EQ(all.model.particles[1].id, 1150);
  EXPECT_EQ(motions_in_all(find_mechanisms(all.model, all.network, all.dofs, {})), 1);
}

TEST(Condensed, OwnersMaskCounts) {
  Net net;
  net.hold(chain(net, {0, 0, 0}, {1, 0, 0}, 6)[3]);
  std::vector<NetPiece> pieces = cut(net, {0, 0, 0, 1, 1, 1}, 2);
  ASSERT_THAT(pieces[0].number, ElementsAre(0, 1, 2, 3));
  pieces[0].dofs = number_free_dofs({0x3f, 0x3f, 0x3f, 0x3f});
  for (int order = 0; order < 2; ++order) {
    const Assembled all = assembled(pieces);
    EXPECT_THAT(find_mechanisms(all.model, all.network, all.dofs, {}), IsEmpty());
    std::swap(pieces[0], pieces[1]);
    for (NetPiece& piece : pieces) piece.network.share = &piece.share;
  }
}

Net lattice(Index side, const SectionStiffness& law) {
  Net net;
  for (Index p = 0; p < side * side * side; ++p) {
    net.particle(Vector3(double(p % side), double(p / side % side), double(p / (side * side))));
    for (const Index step : {Index(1), side, side * side})
      if (p / step % side > 0) net.bond(p - step, p, law);
  }
  return net;
}

TEST(Condensed, WeldedPackingShrinksToItsSurface) {
  for (const Index side : {6, 12, 24}) {
    Net net = lattice(side, beam);
    const Index face = side * side, held = net.count() - 1;
    net.hold(held);
    for (const int ranks : {1, 2}) {
      const std::vector<NetPiece> pieces = cut(net, by_place(net, ranks), ranks);
      for (const NetPiece& piece : pieces) {
        const Condensed c = condensed(piece);
        // Both sides of the cut, the held one, the end of the set.
        EXPECT_LE(c.number.size(), std::size_t(ranks == 1 ? 2 : 2 * face + 2));
        EXPECT_EQ(c.links.size(), c.number.size() - 1);
      }
      const Assembled all = assembled(pieces);
      EXPECT_LE(all.number.size(), std::size_t(ranks == 1 ? 2 : 2 * face + 3));
      EXPECT_THAT(find_mechanisms(all.model, all.network, all.dofs, {}), IsEmpty());
    }
  }
}

TEST(Condensed, NetworkWithoutMomentsDoesNotShrink) {
  const Net net = lattice(6, contact);
  const std::vector<NetPiece> pieces = cut(net, by_place(net, 4), 4);
  for (const NetPiece& piece : pieces) EXPECT_THAT(condensed(piece).number, SizeIs(piece.number.size()));
  const Assembled all = assembled(pieces);
  EXPECT_THAT(all.number, SizeIs(std::size_t(net.count())));
  EXPECT_THAT(all.network.links, SizeIs(net.network.links.size()));
}

TEST(Condensed, TravelsBitForBit) {
  Random random(11);
  Net net = random_network(random, 40);
  net.bond(0, 1, {1e9, 1.0 / 3, 7, 1e-12, 1e-3}, 0.1);
  net.free[0] = 0b101010;
  for (const NetPiece& piece : cut(net, by_place(net, 2), 2)) {
    const Condensed c = condensed(piece), received = sent(c);
    EXPECT_FALSE(c.number.empty());
    EXPECT_EQ(fingerprint(received), fingerprint(c));
    EXPECT_EQ(received.own, c.own);
    EXPECT_EQ(received.number, c.number);
    EXPECT_EQ(received.position, c.position);
    EXPECT_EQ(received.radius, c.radius);
    EXPECT_EQ(received.free, c.free);
    ASSERT_EQ(received.links.size(), c.links.size());
    for (std::size_t k = 0; k < c.links.size(); ++k) {
      const Link &sent_link = c.links[k], &link = received.links[k];
      EXPECT_EQ(std::tie(link.a, link.b, link.branch, link.fraction),
                std::tie(sent_link.a, sent_link.b, sent_link.branch, sent_link.fraction));
      const SectionStiffness &k1 = link.stiffness, &k2 = sent_link.stiffness;
      EXPECT_EQ(std::tie(k1.kn, k1.ks, k1.kt, k1.kb, k1.coupling),
                std::tie(k2.kn, k2.ks, k2.kt, k2.kb, k2.coupling));
    }
  }
}

}  // namespace
}  // namespace bondstatic
