#include "report/force_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "report/grids.hpp"
#include "report/rose.hpp"

namespace bondstatic {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;

constexpr std::array xy{0, 1};

TEST(Rose, BondsCountInBothDirections) {
  Rose rose;
  rose.add(Vector3(1, 0, 0), xy, 2);
  rose.add(Vector3(-3, 0, 0), xy, 4);
  rose.add(Vector3(0, -1, 0), xy, 5);
  std::vector<double> expected(petals);
  expected[0] = expected[18] = 2;
  expected[9] = expected[27] = 1;
  EXPECT_EQ(rose.counts(), expected);
  EXPECT_EQ(rose.bonds(), 3);
  EXPECT_EQ(rose.means()[0], 3);
  EXPECT_EQ(rose.means()[27], 5);
  EXPECT_TRUE(std::isnan(rose.means()[1]));
  EXPECT_EQ(rose_angles()[9], 90);
}

TEST(Rose, BondsBetweenTwoPetalsAreHalved) {
  Rose rose;
  rose.add(Vector3(1, 1, 0), xy, 6);
  rose.add(Vector3(-1, 1, 0), xy, 6);
  for (const std::size_t petal : {4, 5, 13, 14, 22, 23, 31, 32}) {
    EXPECT_EQ(rose.counts()[petal], 0.5);
    EXPECT_EQ(rose.means()[petal], 6);
  }
}

TEST(Rose, BondsAcrossThePlaneHaveNoDirection) {
  Rose rose;
  rose.add(Vector3(0.1, 0, 1), xy, 1);
  rose.add(Vector3(0, 0, 0), xy, 1);
  EXPECT_EQ(rose.bonds(), 0);
  rose.add(Vector3(0.11, 0, 1), xy, 1);
  EXPECT_EQ(rose.bonds(), 1);
}

// 36,000 directions evenly over the sphere: every petal has 2,000 of their both ends, give or take.
TEST(Rose, IsotropicBondsMakeACircle) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> number;
  Rose rose;
  for (int i = 0; i < 36'000; ++i) rose.add(Vector3::NullaryExpr([&] { return number(random); }), xy, 1);
  EXPECT_THAT(rose.counts(), Each(AllOf(Ge(1800), Le(2200))));
}

struct ForcePlots : testing::Test {
  const test::ScratchFolder scratch;
  Model model;
  State state;

  /// A bond of the length 1 along each branch, from particles of its own.
  void bond(const Vector3& branch, double normal_force) {
    const Index a = test::add_particle(model, Vector3(3.0 * double(model.bonds.size()), 0, 0), 0.4);
    const Index b = test::add_particle(model, model.particles.back().position + branch, 0.4);
    test::add_bond(model, a, b);
    BondResult result;
    result.normal_force = normal_force;
    state.bonds.push_back(result);
  }
  std::vector<PagePlot> plots(const std::vector<Column>& more_of_bonds = {}, bool with_directions = true) {
    if (model.blocks.empty())
      model.blocks = {test::block("generic", {{"kn", 1}, {"ks", 1}, {"kt", 1}, {"kb", 1}})};
    state.displacement.assign(model.particles.size(), Vector6::Zero());
    state.reaction = state.displacement;
    const Grid grid({test::write_grid_file(scratch, "out", model, state, more_of_bonds)});
    std::vector<PagePlot> found;
    add_force_plots(grid, "", with_directions, true, found);
    return found;
  }
};

TEST_F(ForcePlots, HistogramTellsTensionFromCompression) {
  for (int i = 1; i <= 20; ++i) bond(Vector3::UnitX(), 0.5 * i);   // up to 10
  for (int i = 1; i <= 62; ++i) bond(Vector3::UnitX(), -0.5 * i);  // down to -31: 41 bins of 1
  bond(Vector3::UnitX(), 0);
  bond(Vector3::UnitX(), not_given);
  const auto found = plots();
  ASSERT_EQ(found.size(), 1u);  // nothing but x: no plane
  const PagePlot& plot = found[0];
  EXPECT_EQ(plot.title, "Normal forces of bonds");
  EXPECT_EQ(plot.x.unit, "N");
  ASSERT_EQ(plot.series.size(), 2u);
  const PageSeries &compression = plot.series[0], &tension = plot.series[1];
  EXPECT_EQ(compression.name, "compression");
  ASSERT_EQ(compression.x.size(), 31u);
  EXPECT_NEAR(compression.x.front(), -30.5, 1e-12);
  EXPECT_NEAR(compression.x.back(), -0.5, 1e-12);
  EXPECT_EQ(std::accumulate(compression.y.begin(), compression.y.end(), 0.0), 62);
  EXPECT_EQ(tension.name, "tension");
  ASSERT_EQ(tension.x.size(), 10u);
  EXPECT_NEAR(tension.x.front(), 0.5, 1e-12);
  EXPECT_EQ(std::accumulate(tension.y.begin(), tension.y.end(), 0.0), 20);
  EXPECT_EQ(plot.note,
            "tension in 20 bonds, mean 5.25 N; compression in 62 bonds, mean 15.75 N; 2 bonds carry none");
}

TEST_F(ForcePlots, EqualForcesAreOneSide) {
  bond(Vector3::UnitX(), -3);
  bond(Vector3::UnitX(), -3);
  const auto found = plots();
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].series.size(), 1u);
  EXPECT_EQ(found[0].series[0].y.front(), 2);
  EXPECT_THAT(found[0].note, HasSubstr("no tension"));
}

TEST_F(ForcePlots, FewLargeForcesAmongManySmallOnesAreSeen) {
  bond(Vector3::UnitX(), 1000);
  for (int i = 0; i < 98; ++i) bond(Vector3::UnitX(), 1);
  EXPECT_FALSE(plots().at(0).y.log);
  bond(Vector3::UnitX(), 1);
  EXPECT_TRUE(plots().at(0).y.log);
}

TEST_F(ForcePlots, WithoutForcesThereIsNoHistogram) {
  bond(Vector3::UnitX(), 0);
  EXPECT_THAT(plots(), IsEmpty());
}

TEST_F(ForcePlots, PlanesThatTheModelExtendsInHaveRoses) {
  bond(Vector3::UnitX(), 1);
  bond(Vector3::UnitZ(), -2);
  bond(Vector3::UnitZ(), -4);
  const auto found = plots();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[1].title, "Directions of bonds, xz plane");
  EXPECT_EQ(found[1].kind, PagePlot::Kind::rose);
  EXPECT_EQ(found[1].x.label, "from x towards z");
  EXPECT_EQ(found[1].series[0].y[9], 2);
  EXPECT_EQ(found[2].title, "Mean size of the normal force, xz plane");
  EXPECT_EQ(found[2].y.unit, "N");
  EXPECT_EQ(found[2].series[0].y[0], 1);
  EXPECT_EQ(found[2].series[0].y[9], 3);
  EXPECT_EQ(plots({}, false).size(), 2u);
}

TEST_F(ForcePlots, BrokenBondsHaveTheirOwnRose) {
  bond(Vector3::UnitX(), 1);
  bond(Vector3::UnitY(), 0);
  const auto found = plots({{"break_step", std::vector<Index>{0, 5}}});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[1].series[0].y[9], 0);
  EXPECT_EQ(found[2].title, "Directions of broken bonds, xy plane");
  EXPECT_EQ(found[2].series[0].y[0], 0);
  EXPECT_EQ(found[2].series[0].y[9], 1);
}

}  // namespace
}  // namespace bondstatic
