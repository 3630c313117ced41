// Generated models: the count of free motions against a brute-force SVD, and the campaign of planted defects.
// BONDSTATIC_FULL=1 runs ten times as many.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mechanism/constraint_rows.hpp"
#include "mechanism/random_models.hpp"

namespace bondstatic {
namespace {

using namespace test;
using Kind = Mechanism::Kind;

std::vector<bool> held_particles(const Net& net) {
  std::vector<bool> held(std::size_t(net.count()));
  for (Index p = 0; p < net.count(); ++p) held[std::size_t(p)] = net.free[std::size_t(p)] != 0x3f;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Link& link : net.network.links)
      if (held[std::size_t(link.a)] != held[std::size_t(link.b)])
        held[std::size_t(link.a)] = held[std::size_t(link.b)] = changed = true;
  }
  return held;
}

class RandomNetwork : public ::testing::TestWithParam<int> {};

// Laws of every kind of deficiency, supports of every kind of dof. Twenty models a test.
TEST_P(RandomNetwork, HasAsManyFreeMotionsAsBruteForceFinds) {
  const int models = full_run() ? 200 : 20;
  Index singular = 0;
  for (int m = 0; m < models; ++m) {
    const std::uint64_t seed = std::uint64_t(GetParam()) * 1000 + std::uint64_t(m);
    Random random(seed);
    const Net net = random_network(random, 30);
    const auto held = held_particles(net);
    double gap = 0;
    const Eigen::MatrixXd expected = brute_force_motions(net, held, gap);
    ASSERT_GT(gap, 1e-8) << "seed " << seed << " is not clear-cut, choose another";
    std::set<Index> moving, reported;
    for (Index p = 0; p < net.count(); ++p)
      if (expected.cols() > 0 && expected.middleRows(6 * p, 6).norm() > 1e-7) moving.insert(p);
    Index count = 0;
    for (const Mechanism& mechanism : net.mechanisms()) {
      const bool is_held = held[std::size_t(mechanism.particles.front())];
      EXPECT_EQ(is_held, mechanism.kind == Kind::underconstrained || mechanism.kind == Kind::internal);
      if (!is_held) continue;
      count += Index(mechanism.motions.size());
      reported.insert(mechanism.particles.begin(), mechanism.particles.end());
    }
    EXPECT_EQ(count, expected.cols()) << "seed " << seed << ", smallest strain of the rest " << gap;
    EXPECT_EQ(reported, moving) << "seed " << seed;
    singular += count > 0;
  }
  EXPECT_GT(singular, models / 5);
  EXPECT_LT(singular, models);
}

INSTANTIATE_TEST_SUITE_P(Mechanism, RandomNetwork, ::testing::Range(0, 24));

class LargeContactPacking : public ::testing::TestWithParam<int> {};

// Growth and patches only make the null space smaller to find: taken of the single particles it has as many
// vectors.
TEST_P(LargeContactPacking, IsCountedTheSameWithoutReduction) {
  Random random(std::uint64_t(GetParam()) + 90);
  Net net = random_packing(random, 450, 1.9);
  const double friction = GetParam() % 3 == 0 ? 1 : 0.97;
  bond_neighbours(net, 1.35, [&](Index a, Index b) {
    net.bond(a, b, uniform(random) < friction ? contact : frictionless);
  });
  if (GetParam() % 2) {
    net.hold(7);
  } else {
    for (Index p = 0; p < net.count(); ++p)
      if (net.at(p)[2] < 0.7) net.hold(p);
  }
  const auto held = held_particles(net);
  std::vector<Constraint> constraints;
  for (const Link& link : net.network.links)
    if (held[std::size_t(link.a)])
      append_constraints(constraints, link, link.a, link.b, net.at(link.a), net.at(link.b));
  std::vector<std::vector<Index>> single;
  std::vector<Vector3> places;
  for (Index p = 0; p < net.count(); ++p) {
    append_support(constraints, p, net.at(p),
                   held[std::size_t(p)] ? net.free[std::size_t(p)] : std::uint8_t(0));
    single.push_back({p});
    places.push_back(net.at(p));
  }
  const auto rows = constraint_rows(make_bodies(net.model, single, constraints), constraints);
  std::vector<Mechanism> found = net.mechanisms();
  std::erase_if(found, [&](const Mechanism& m) { return !held[std::size_t(m.particles.front())]; });
  EXPECT_EQ(motions_in_all(found), Index(null_space(places, rows).size()));
}

INSTANTIATE_TEST_SUITE_P(Mechanism, LargeContactPacking, ::testing::Range(0, 6));

class MechanismCampaign : public ::testing::TestWithParam<int> {
 protected:
  int models_ = full_run() ? 100 : 10;
  std::uint64_t seed(int m) const { return 7000000 + std::uint64_t(GetParam()) * 1000 + std::uint64_t(m); }
};

TEST_P(MechanismCampaign, FindsThePlantedParticle) {
  for (int m = 0; m < models_; ++m) {
    Random random(seed(m));
    Sound sound = sound_model(random);
    const auto defect = Defect(m % defects);
    const Index planted = plant(random, sound, defect);
    const auto found = sound.net.mechanisms();
    bool named = false;
    for (const Mechanism& mechanism : found) {
      named = named || std::count(mechanism.particles.begin(), mechanism.particles.end(), planted) > 0;
      EXPECT_FALSE(mechanism.motions.empty());
      EXPECT_FALSE(describe(sound.net.model, mechanism).empty());
    }
    EXPECT_TRUE(named) << "seed " << seed(m) << " defect " << defect;
    EXPECT_EQ(found.size(), 1u) << "seed " << seed(m) << " defect " << defect;
  }
}

TEST_P(MechanismCampaign, RaisesNoFalseAlarm) {
  for (int m = 0; m < models_; ++m) {
    Random random(seed(m) + 500);
    Sound sound = sound_model(random);
    hold_well(random, sound.net);
    // The same additions as the defects, one bond or more to the good.
    const Index count = sound.net.count(), root = pick(random, count - 1);
    const Index p = sound.net.particle(sound.net.at(root) + 1.1 * sound.spacing * direction(random));
    if (m % 2)
      sound.net.bond(root, p, scattered(random, beam));
    else
      for (const Index foot : {Index(0), Index(1), count - 1})
        sound.net.bond(foot, p, scattered(random, contact));
    const auto found = sound.net.mechanisms();
    EXPECT_THAT(found, ::testing::IsEmpty()) << "seed " << seed(m);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanism, MechanismCampaign, ::testing::Range(0, 10));

}  // namespace
}  // namespace bondstatic
