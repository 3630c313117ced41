#include "model/generators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "model/neighbours.hpp"

namespace bondstatic::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Pairs at most `distance` apart.
std::size_t bonds_within(const std::vector<Vector3>& points, double distance) {
  return touching_pairs(points, std::vector<double>(points.size(), distance / 2 * (1 + 1e-9))).size();
}

TEST(Line, EndsAreExactAndStepsEven) {
  const auto points = line_points({0.1, 0, 0}, {0.7, -3, 1e-3}, 7);
  ASSERT_EQ(points.size(), 7u);
  EXPECT_EQ(points.front(), Vector3(0.1, 0, 0));
  EXPECT_EQ(points.back(), Vector3(0.7, -3, 1e-3));
  for (std::size_t i = 0; i + 1 < 7; ++i) EXPECT_NEAR((points[i + 1] - points[i]).y(), -0.5, 1e-15);
}

TEST(Line, StepsAreCountedFromTheFirst) {
  const auto points = stepped_points({1, 2, 3}, {0, 0.4, 0}, 11);
  EXPECT_EQ(points.size(), 11u);
  EXPECT_EQ(points[10], Vector3(1, 6, 3));
}

TEST(Arc, QuarterTurnsRightHandedAboutItsAxis) {
  const auto points = arc_points(
      {.centre = {1, 1, 1}, .radius = 2, .axis = {0, 0, 1}, .start = {1, 0, 5}, .angle = pi / 2, .count = 3});
  EXPECT_LT((points[0] - Vector3(3, 1, 1)).norm(), 1e-15);
  EXPECT_LT((points[1] - Vector3(1 + std::sqrt(2), 1 + std::sqrt(2), 1)).norm(), 1e-15);
  EXPECT_LT((points[2] - Vector3(1, 3, 1)).norm(), 1e-15);
}

TEST(Arc, ClosedCircleDoesNotRepeatItsFirstPoint) {
  const auto points = arc_points({.radius = 1, .axis = Vector3(1, 2, 2) / 3, .angle = 2 * pi, .count = 12});
  EXPECT_EQ(bonds_within(points, 2 * std::sin(pi / 12)), 12u);
}

TEST(Helix, ClimbsByItsPitchAndKeepsItsRadius) {
  const Vector3 axis = Vector3(2, -1, 2) / 3;
  const Arc helix{
      .centre = {0, 0, 1}, .radius = 0.3, .axis = axis, .angle = 6 * pi, .pitch = 0.5, .count = 61};
  const auto points = arc_points(helix);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 arm = points[i] - helix.centre;
    EXPECT_NEAR(arm.dot(axis), 1.5 * double(i) / 60, 1e-15);
    EXPECT_NEAR((arm - arm.dot(axis) * axis).norm(), 0.3, 1e-15);
  }
}

TEST(Arc, StartAlongTheAxisIsNoDirection) {
  EXPECT_TRUE((Arc{.axis = {0, 0, 1}, .start = {0, 0, -4}}.start_along_axis()));
  EXPECT_FALSE((Arc{.axis = {0, 0, 1}, .start = {1e-3, 0, 1}}.start_along_axis()));
  EXPECT_FALSE((Arc{.axis = {0, 0, 1}}.start_along_axis()));
}

TEST(Lattice, SimpleCubicCounts) {
  const auto points = lattice_points(LatticeKind::simple_cubic, {3, 4, 5}, 0.4, {1, 0, 0});
  EXPECT_EQ(points.size(), 60u);
  EXPECT_EQ(points[0], Vector3(1, 0, 0));
  EXPECT_EQ(points[1], Vector3(1.4, 0, 0));  // x runs fastest
  EXPECT_EQ(bonds_within(points, 0.4), 2u * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4);
}

TEST(Lattice, BccCountsByHand) {
  // Each of the n^3 body centres meets the corner points of its cell that exist: 2 n - 1 along each axis in
  // all.
  for (const Index n : {1, 2, 3}) {
    const auto points = lattice_points(LatticeKind::bcc, {n, n, n}, 2, {0, 0, 0});
    EXPECT_EQ(points.size(), std::size_t(2 * n * n * n));
    EXPECT_EQ(bonds_within(points, std::sqrt(3)), std::size_t((2 * n - 1) * (2 * n - 1) * (2 * n - 1)));
  }
}

TEST(Lattice, FccCountsByHand) {
  // One cell: a tetrahedron of four points. In the bulk each point has 12 neighbours.
  const double a = 0.3;
  EXPECT_EQ(bonds_within(lattice_points(LatticeKind::fcc, {1, 1, 1}, a, {0, 0, 0}), a / std::sqrt(2)), 6u);
  const auto points = lattice_points(LatticeKind::fcc, {4, 4, 4}, a, {0, 0, 0});
  EXPECT_EQ(points.size(), 256u);
  std::vector<int> neighbours(points.size());
  for (const auto& [i, j] :
       touching_pairs(points, std::vector<double>(points.size(), a / std::sqrt(8) * (1 + 1e-9)))) {
    ++neighbours[std::size_t(i)];
    ++neighbours[std::size_t(j)];
  }
  EXPECT_EQ(*std::max_element(neighbours.begin(), neighbours.end()), 12);
}

TEST(Jitter, StaysInItsBoundsAndFollowsTheSeed) {
  std::vector<Vector3> points(1000, Vector3::Zero()), again = points, other = points;
  const std::vector<double> most(1000, 0.25);
  jitter(points, most, 1);
  jitter(again, most, 1);
  jitter(other, most, 2);
  EXPECT_EQ(points, again);
  EXPECT_NE(points, other);
  Vector3 mean = Vector3::Zero();
  for (const Vector3& point : points) {
    EXPECT_LE(point.cwiseAbs().maxCoeff(), 0.25);
    mean += point / 1000;
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4 * 0.25 / std::sqrt(3 * 1000.0));  // four deviations
}

TEST(Survivors, AreAsManyAsAskedForAndSpreadEvenly) {
  for (const double fraction : {0.0, 0.1, 0.5, 0.999}) {
    const auto stay = survivors(1000, fraction, 7);
    EXPECT_EQ(stay.size(), std::size_t(1000 - std::llround(1000 * fraction)));
    EXPECT_TRUE(std::is_sorted(stay.begin(), stay.end()));
    EXPECT_EQ(std::set<Index>(stay.begin(), stay.end()).size(), stay.size());
  }
  const auto half = survivors(10'000, 0.5, 7);
  const auto low = std::count_if(half.begin(), half.end(), [](Index i) { return i < 5000; });
  EXPECT_NEAR(double(low), 2500, 4 * 25);  // hypergeometric, deviation 25
  EXPECT_NE(survivors(1000, 0.5, 7), survivors(1000, 0.5, 8));
}

}  // namespace
}  // namespace bondstatic::test
