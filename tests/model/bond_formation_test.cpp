#include "model/bond_formation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace bondstatic::test {
namespace {

std::vector<Particle> row(Index count, double pitch, double radius) {
  std::vector<Particle> particles;
  for (Index i = 0; i < count; ++i) particles.push_back({i + 1, Vector3(pitch * double(i), 0, 0), radius});
  return particles;
}

TEST(BondFormation, TouchingParticlesBondInSpiteOfRounding) {
  for (const double pitch : {0.4, 0.1, 1.0 / 3, 7e-4, 1e5 / 7})
    for (const Index count : {2, 11, 1000})
      EXPECT_EQ(bonded_pairs(row(count, pitch, pitch / 2), {}).size(), std::size_t(count - 1)) << pitch;
}

TEST(BondFormation, GapAndFactorReachAsFarAsTheySay) {
  const std::vector<Particle> particles = row(11, 0.5, 0.2);  // gaps of 0.1
  EXPECT_TRUE(bonded_pairs(particles, {}).empty());
  EXPECT_EQ(bonded_pairs(particles, {.gap = 0.1}).size(), 10u);
  EXPECT_TRUE(bonded_pairs(particles, {.gap = 0.0999}).empty());
  EXPECT_EQ(bonded_pairs(particles, {.contact_radius_factor = 1.25}).size(), 10u);
  EXPECT_TRUE(bonded_pairs(particles, {.contact_radius_factor = 1.2499}).empty());
  EXPECT_EQ(bonded_pairs(particles, {.gap = 0.6}).size(), 19u);
}

TEST(BondFormation, NegativeGapAsksForOverlap) {
  const std::vector<Particle> particles{{1, {0, 0, 0}, 10}, {2, {9, 0, 0}, 0.1}, {3, {10.05, 0, 0}, 0.1}};
  EXPECT_EQ(bonded_pairs(particles, {.gap = -0.5}), (std::vector<std::pair<Index, Index>>{{0, 1}}));
  EXPECT_EQ(bonded_pairs(particles, {}).size(), 2u);
}

TEST(BondFormation, EqualsBruteForceWithShuffledIdsAndGroups) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Particle> particles;
    for (Index i = 0; i < 150; ++i)
      particles.push_back({(i * 67) % 151, Vector3(uniform(random), uniform(random), uniform(random)),
                           0.01 * std::pow(10, uniform(random))});
    PositionLists between;
    for (Index p = 0; p < 150; ++p) {
      if (uniform(random) < 0.5) between.first.push_back(p);
      if (uniform(random) < 0.5) between.second.push_back(p);
    }
    const Formation formation{.gap = 0.05 * (uniform(random) - 0.3),
                              .contact_radius_factor = 1 + uniform(random)};
    std::vector<std::pair<Index, Index>> expected;
    const auto in = [](const std::vector<Index>& list, Index p) {
      return std::binary_search(list.begin(), list.end(), p);
    };
    for (Index a = 0; a < 150; ++a)
      for (Index b = 0; b < 150; ++b) {
        const Particle &pa = particles[std::size_t(a)], &pb = particles[std::size_t(b)];
        const double sum = pa.radius + pb.radius, length = (pb.position - pa.position).norm();
        const bool sides = (in(between.first, a) && in(between.second, b)) ||
                           (in(between.second, a) && in(between.first, b));
        if (pa.id < pb.id && sides &&
            length <= formation.contact_radius_factor * sum + formation.gap + 1e-9 * sum)
          expected.emplace_back(a, b);
      }
    std::sort(expected.begin(), expected.end(), [&](const auto& l, const auto& r) {
      const auto id = [&](Index p) { return particles[std::size_t(p)].id; };
      return std::pair(id(l.first), id(l.second)) < std::pair(id(r.first), id(r.second));
    });
    ASSERT_EQ(bonded_pairs(particles, formation, &between), expected) << "trial " << trial;
  }
}

}  // namespace
}  // namespace bondstatic::test
