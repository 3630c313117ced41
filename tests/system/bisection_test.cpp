#include "system/bisection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace bondstatic {
namespace {

std::vector<Vector3> cloud(int count, const Vector3& extent) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
    points.push_back(extent.cwiseProduct(Vector3(part(random), part(random), part(random))));
  return points;
}

TEST(Bisection, PartsAreEqualForAnyNumberOfThem) {
  const auto points = cloud(1000, {1, 2, 3});
  for (const int parts : {1, 2, 3, 4, 5, 7, 16}) {
    const std::vector<int> part = bisect(points, parts);
    for (int k = 0; k < parts; ++k) {
      const auto size = double(std::count(part.begin(), part.end(), k));
      EXPECT_NEAR(size, 1000.0 / parts, 2) << k << " of " << parts;
    }
  }
}

TEST(Bisection, CutsAcrossTheLongestExtent) {
  const auto points = cloud(100, {1, 1, 10});
  const std::vector<int> part = bisect(points, 2);
  double low = 10, high = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    part[i] == 0 ? high = std::max(high, points[i].z()) : low = std::min(low, points[i].z());
  EXPECT_LT(high, low);
}

TEST(Bisection, PointsOfEqualPlaceGoByTheirNumber) {
  const std::vector<Vector3> points(4, Vector3::Ones());
  EXPECT_EQ(bisect(points, 2), (std::vector<int>{0, 0, 1, 1}));
}

TEST(Bisection, MorePartsThanPointsLeavesSomeEmpty) {
  const auto points = cloud(2, {1, 1, 1});
  std::vector<int> part = bisect(points, 4);
  std::sort(part.begin(), part.end());
  EXPECT_NE(part[0], part[1]);
  EXPECT_TRUE(bisect({}, 3).empty());
}

}  // namespace
}  // namespace bondstatic
