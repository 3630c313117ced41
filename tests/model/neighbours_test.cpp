#include "model/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bondstatic::test {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

struct Spheres {
  std::vector<Vector3> positions;
  std::vector<double> reach;
};

/// Radii from `smallest` to spread * smallest, log-uniform; in a box that makes a few neighbours each.
Spheres random_spheres(std::size_t count, double spread, double unit, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Spheres spheres;
  double volume = 0;
  for (std::size_t i = 0; i < count; ++i) {
    spheres.reach.push_back(unit * std::pow(spread, uniform(random)));
    volume += std::pow(spheres.reach.back(), 3);
  }
  const double box = std::cbrt(8 * volume);
  for (std::size_t i = 0; i < count; ++i)
    spheres.positions.push_back(box * Vector3(uniform(random) - 0.7, uniform(random), uniform(random) - 3));
  return spheres;
}

Pairs brute_force(const Spheres& spheres) {
  Pairs pairs;
  for (std::size_t i = 0; i < spheres.reach.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.reach.size(); ++j) {
      const double sum = spheres.reach[i] + spheres.reach[j];
      if ((spheres.positions[i] - spheres.positions[j]).squaredNorm() <= sum * sum)
        pairs.emplace_back(Index(i), Index(j));
    }
  return pairs;
}

class Polydisperse : public testing::TestWithParam<double> {};

TEST_P(Polydisperse, PairsAreThoseOfBruteForce) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const double unit : {1e-6, 1.0, 1e3}) {
      const Spheres spheres = random_spheres(400, GetParam(), unit, seed);
      const Pairs pairs = touching_pairs(spheres.positions, spheres.reach);
      ASSERT_EQ(pairs, brute_force(spheres)) << "seed " << seed;
      found += pairs.size();
    }
  EXPECT_GT(found, 300u);
}

TEST_P(Polydisperse, PairsDoNotDependOnTheThreads) {
  const Spheres spheres = random_spheres(20000, GetParam(), 1.0, 9);
  const Pairs pairs = touching_pairs(spheres.positions, spheres.reach);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  for (const int threads : {2, 4})
    EXPECT_EQ(touching_pairs(spheres.positions, spheres.reach, threads), pairs);
}

INSTANTIATE_TEST_SUITE_P(Spreads, Polydisperse, testing::Values(1.0, 2.0, 10.0, 1000.0, 1e6));

TEST(Neighbours, OfNoneAndOne) {
  EXPECT_TRUE(touching_pairs({}, {}).empty());
  const std::vector<Vector3> one{Vector3::Zero()};
  EXPECT_TRUE(touching_pairs(one, std::vector<double>{1}).empty());
}

TEST(Neighbours, TouchingInOnePointCount) {
  const std::vector<Vector3> x{{0, 0, 0}, {3, 0, 0}, {3, 1.5, 0}, {-1, 0, 0}};
  EXPECT_EQ(touching_pairs(x, std::vector<double>{1, 2, 0.25, 0}), (Pairs{{0, 1}, {0, 3}, {1, 2}}));
}

TEST(Neighbours, CoincidentAndPointLikeSpheres) {
  const std::vector<Vector3> x(5, Vector3(1, 2, 3));
  EXPECT_EQ(touching_pairs(x, std::vector<double>(5, 0.0)).size(), 10u);
  EXPECT_EQ(touching_pairs(x, std::vector<double>(5, 1.0)).size(), 10u);
}

TEST(Neighbours, FarApartSpheresDoNotOverflowTheCells) {
  const std::vector<Vector3> x{{-1e200, 0, 0}, {1e200, 1, 1}, {0, 1e-200, 0}, {0, 0, 0}};
  EXPECT_EQ(touching_pairs(x, std::vector<double>{1e-3, 1e-3, 1e-200, 1e-200}), (Pairs{{2, 3}}));
}

TEST(Neighbours, OneHugeSphereAmongManySmallOnesStaysLinear) {
  // Slow with one grid: cells of the small ones' size make the huge one look into millions, cells of its own
  // size hold thousands of small ones.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  Spheres spheres;
  for (int i = 0; i < 50'000; ++i) {
    spheres.positions.push_back(100 * Vector3(uniform(random), uniform(random), uniform(random)));
    spheres.reach.push_back(0.1);
  }
  spheres.positions.push_back(Vector3(50, 50, 50));
  spheres.reach.push_back(20);
  const Pairs pairs = touching_pairs(spheres.positions, spheres.reach);
  const auto huge =
      std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second == 50'000; });
  EXPECT_NEAR(double(huge), 50'000 * 4.0 / 3 * 3.14159 * std::pow(20.1 / 100, 3),
              4 * 41.0);  // four deviations
}

}  // namespace
}  // namespace bondstatic::test
