// Images in periodic cells, and bonds across their faces.
#include "model/cell.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "model/bond_formation.hpp"
#include "model/hold_cell.hpp"

namespace bondstatic::test {
namespace {

Cell skewed() {
  Cell cell;
  cell.edges << 3, 1.4, -1.2, 0, 2.5, 1.1, 0, 0, 2.8;
  cell.origin = {-1, 2, 0.5};
  return cell;
}

TEST(CellGeometry, VolumeAndHeights) {
  const Cell cell = skewed();
  EXPECT_NEAR(volume(cell), 3 * 2.5 * 2.8, 1e-14);
  for (int i = 0; i < 3; ++i) {
    const Vector3 normal = cell.edges.col((i + 1) % 3).cross(cell.edges.col((i + 2) % 3)).normalized();
    EXPECT_NEAR(height(cell, i), std::abs(normal.dot(cell.edges.col(i))), 1e-14);
  }
}

TEST(CellGeometry, NearestImageIsTheNearestOfMany) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(-20, 20);
  for (int n = 0; n < 350; ++n) {
    Cell cell = skewed();
    const int edges = 1 + n % 7;  // at least one of the three
    cell.periodic = {(edges & 1) != 0, (edges & 2) != 0, (edges & 4) != 0};
    const Vector3 branch(anywhere(random), anywhere(random), anywhere(random));
    const NearestImage found = nearest_image(cell, branch);
    EXPECT_NEAR((branch + shift_of(cell, found.image)).norm(), found.length, 1e-13);
    double nearest = 1e300, next = 1e300;
    const auto reach = [&](std::size_t i) { return cell.periodic[i] ? 25 : 0; };
    for (int i = -reach(0); i <= reach(0); ++i)
      for (int j = -reach(1); j <= reach(1); ++j)
        for (int k = -reach(2); k <= reach(2); ++k) {
          const double distance = (branch + shift_of(cell, {i, j, k})).norm();
          if (distance < nearest)
            next = nearest, nearest = distance;
          else
            next = std::min(next, distance);
        }
    EXPECT_NEAR(found.length, nearest, 1e-13);
    EXPECT_LE(found.next_length, next + 1e-13);
    EXPECT_GE(found.next_length, found.length);
    if (next < 1.1 * nearest) {
      EXPECT_NEAR(found.next_length, next, 1e-13);
    }
  }
}

TEST(CellGeometry, OnlyStrainsAlongPeriodicEdgesCanBeTaken) {
  Cell cell = skewed();
  Matrix3 strain;
  strain << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  EXPECT_LT(strain_across_ends(cell, strain), 1e-14);
  cell.periodic = {true, true, false};  // the x-y plane
  EXPECT_EQ(strain_across_ends(cell, strain), 6);
  strain.row(2).setZero(), strain.col(2).setZero();
  EXPECT_LT(strain_across_ends(cell, strain), 1e-14);
  cell.periodic = {true, false, false};
  EXPECT_NEAR(strain_across_ends(cell, strain), 4, 1e-14);
}

// Every pair of images within a few cells, one by one.
TEST(BondFormation, AcrossFacesAgreesWithBruteForce) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> along(-0.4, 1.7), radius(0.1, 0.5);
  for (int n = 0; n < 20; ++n) {
    Cell cell = skewed();
    cell.periodic = {n % 4 != 1, n % 4 != 2, n % 4 != 3};
    std::vector<Particle> particles;
    for (int p = 0; p < 25; ++p)
      particles.push_back({100 - p,
                           cell.origin + cell.edges * Vector3(along(random), along(random), along(random)),
                           n % 5 == 0 && p == 0 ? 1.6 : radius(random)});
    const Formation formation{0.05, 1.2};
    using Key = std::tuple<Index, Index, CellImage>;
    std::set<Key> expected, found;
    const auto reach = [&](std::size_t i) { return cell.periodic[i] ? 5 : 0; };
    for (std::size_t a = 0; a < particles.size(); ++a)
      for (std::size_t b = 0; b < particles.size(); ++b)
        for (int i = -reach(0); i <= reach(0); ++i)
          for (int j = -reach(1); j <= reach(1); ++j)
            for (int k = -reach(2); k <= reach(2); ++k) {
              const CellImage image{i, j, k};
              const bool once = particles[a].id < particles[b].id || (a == b && image > CellImage{});
              const Vector3 branch = particles[b].position - particles[a].position + shift_of(cell, image);
              if (once && branch.norm() <= 1.2 * (particles[a].radius + particles[b].radius) + 0.05)
                expected.insert({Index(a), Index(b), image});
            }
    for (const BondedImage& bond : bonded_images(particles, cell, formation)) {
      EXPECT_TRUE(found.insert({bond.a, bond.b, bond.image}).second);
      EXPECT_LE(particles[std::size_t(bond.a)].id, particles[std::size_t(bond.b)].id);
    }
    EXPECT_EQ(found, expected) << n;
  }
}

TEST(BondFormation, AcrossFacesBetweenGroups) {
  Cell cell{{0, 0, 0}, 4 * Matrix3::Identity()};
  const std::vector<Particle> particles{{1, {0.2, 0, 0}, 0.5}, {2, {1.2, 0, 0}, 0.5}, {3, {3.2, 0, 0}, 0.5}};
  const PositionLists lists{{0}, {2}};
  const auto bonded = bonded_images(particles, cell, {}, &lists);
  ASSERT_EQ(bonded.size(), 1u);
  EXPECT_EQ(bonded[0].b, 2);
  EXPECT_EQ(bonded[0].image, (CellImage{-1, 0, 0}));
}

TEST(HoldCell, HoldsTheFirstParticleOfTheLargestBody) {
  Model model;
  for (Index p = 0; p < 6; ++p) model.particles.push_back({p + 1, {double(p), 0, 0}, 0.5});
  model.bonds = {{1, 0, 1, {1, 0, 0}}, {2, 4, 3, {-1, 0, 0}}, {3, 5, 4, {-1, 0, 0}}};
  hold_translation(model);
  ASSERT_EQ(model.supports.size(), 1u);
  EXPECT_EQ(model.supports[0].particle, 3);
  EXPECT_EQ(model.supports[0].fixed, (std::array<bool, 6>{true, true, true, false, false, false}));
}

TEST(HoldCell, HoldsEveryBodyThatGoesRoundTheCell) {
  // A ring of three inside the cell; a chain of four round it, its bonds in any direction; a chain through a
  // face and back; one of three that goes round along an edge that is twice as long.
  Model model;
  model.cell = Cell{{0, 0, 0}, 4 * Matrix3::Identity()};
  const auto chain = [&](const std::vector<Vector3>& positions) {
    for (const Vector3& x : positions) model.particles.push_back({Index(model.particles.size() + 1), x, 0.5});
  };
  const auto bond = [&](Index a, Index b, const Vector3& branch) {
    model.bonds.push_back({Index(model.bonds.size() + 1), a, b, branch});
  };
  chain({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}});
  bond(0, 1, {1, 0, 0}), bond(1, 2, {-1, 1, 0}), bond(2, 0, {0, -1, 0});
  chain({{0, 3, 3}, {1, 3, 3}, {2, 3, 3}, {3, 3, 3}});
  bond(6, 3, {1, 0, 0}), bond(5, 4, {-1, 0, 0}), bond(6, 5, {-1, 0, 0}), bond(3, 4, {1, 0, 0});
  chain({{1, 1, 3.5}, {1, 1, 0.5}, {2, 1, 0.5}, {2, 1, 3.5}, {3, 1, 3.5}});
  bond(7, 8, {0, 0, 1}), bond(8, 9, {1, 0, 0}), bond(10, 9, {0, 0, 1}), bond(10, 11, {1, 0, 0}),
      bond(7, 10, {1, 0, 0});
  hold_translation(model);
  std::vector<Index> held;
  for (const Support& support : model.supports) held.push_back(support.particle);
  EXPECT_EQ(held, (std::vector<Index>{3, 7}));
}

}  // namespace
}  // namespace bondstatic::test
