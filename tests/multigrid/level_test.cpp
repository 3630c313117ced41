// The mathematics of one level: rigid links, clumps, Galerkin's product, K u link by link, D^-1.
#include <gtest/gtest.h>

#include <set>

#include "multigrid/coarsen.hpp"
#include "multigrid/level_models.hpp"
#include "multigrid/smoother.hpp"
#include "multigrid/strength.hpp"
#include "multigrid/transfer.hpp"

namespace bondstatic::test {
namespace {

using namespace multigrid;

Matrix6 motion_at(const Vector3& arm) {
  Matrix6 g = Matrix6::Identity();
  g.topRightCorner<3, 3>() = -cross_matrix(arm);
  return g;
}

TEST(RigidLink, StiffnessAtAPointIsFeltAtTheCentreByItsCongruence) {
  const Matrix6 root = Matrix6::Random();
  const Matrix6 c = root * root.transpose(), g = motion_at(Vector3(0.3, -0.7, 1.1));
  EXPECT_LT((seen_from_centre(c, Vector3(0.3, -0.7, 1.1)) - g.transpose() * c * g).norm(), 1e-14 * c.norm());
}

TEST(RigidLink, BondsFeltAtACentreAddUpToTheirCongruences) {
  Link one, other;
  one.branch = Vector3(1, -2, 0.5);
  one.fraction = 0.3;
  one.stiffness = {100, 40, 7, 11, 13};
  other.branch = Vector3(-0.2, 0.7, 0.9);
  other.fraction = 0.6;
  other.stiffness = {5, 3, 2, 1, -0.5};
  const Matrix6 ga = motion_at(arm_a(one)), gb = motion_at(arm_b(other));
  const Matrix6 sum = ga.transpose() * stiffness_of(one) * ga + gb.transpose() * stiffness_of(other) * gb;
  Felt<Link> felt;
  felt.add(one, true);
  felt.add(other, false);
  EXPECT_LT((felt.sum() - sum).norm(), 1e-15 * sum.norm());
}

TEST(LinkStrength, IsThatOfTheWeakestResistance) {
  Link link;
  link.branch = Vector3(0, 0, 2);
  link.stiffness = {100, 50, 4 * 30, 4 * 20, 0};
  const double sound = strength(link);
  EXPECT_GE(sound, 20);
  EXPECT_LT(sound, 30);
  link.stiffness.kb = 0;
  EXPECT_LT(strength(link), 0.2 * sound);
  EXPECT_GT(strength(link), 0);
}

class LevelTest : public ::testing::Test {
 protected:
  LevelProblem problem{9};
  Plan plan;
  Hierarchy<double> hierarchy =
      build_hierarchy<double>(problem.network, problem.incidence, problem.dofs, 2, plan);
};

TEST_F(LevelTest, ClumpsAreConnectedAndTakeInEveryBodyThatMoves) {
  ASSERT_GE(plan.clumps.size(), 2u);
  const Clumps& clumps = plan.clumps.front();
  const Incidence members = members_of(clumps);
  for (Index p = 0; p < problem.network.bodies; ++p)
    EXPECT_EQ(clumps.of[std::size_t(p)] == no_clump, problem.dofs.free[std::size_t(p)] == 0) << p;
  for (Index c = 0; c < clumps.count; ++c) {
    const auto all = members.of(c);
    ASSERT_GE(all.size(), 2u);
    std::set<Index> reached{all.front()};
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const Index p : std::set<Index>(reached))
        for (const Index k : problem.incidence.of(p)) {
          const Link& link = problem.network.links[std::size_t(k)];
          const Index q = link.a == p ? link.b : link.a;
          if (clumps.of[std::size_t(q)] == c) reached.insert(q);
        }
    }
    EXPECT_EQ(reached.size(), all.size()) << "clump " << c;
  }
}

TEST_F(LevelTest, ClumpsDoNotSpanHingesBetweenSoundParts) {
  Model model;
  model.blocks = {block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                  block("contact", {{"kn", 1e9}, {"ks", 1e9}})};
  for (int p = 0; p < 200; ++p) add_particle(model, Vector3(p, 0, 0), 0.5);
  for (int p = 0; p + 1 < 200; ++p) add_bond(model, p, p + 1, p % 10 == 9 ? 1 : 0);
  const BondNetwork network = bond_network(model, bond_properties(model));
  const Incidence incidence = link_incidence(network);
  std::vector<Spring> springs;
  Halo halo;
  const FreeDofs dofs = number_free_dofs(std::vector<std::uint8_t>(200, 0x3f));
  const Clumps clumps = form_clumps(finest_packing(network, incidence, dofs, springs, halo), 1);
  for (int p = 9; p + 1 < 200; p += 10)
    EXPECT_NE(clumps.of[std::size_t(p)], clumps.of[std::size_t(p) + 1]) << p;
}

TEST_F(LevelTest, FinestProductIsTheNaturalForm) {
  const Level<double>& level = hierarchy.levels.front();
  const auto u = problem.random_rows<double>(level.bodies);
  const auto expected = problem.natural_product(plan.numbering.front(), hierarchy.units, u);
  EXPECT_LT(largest_difference(product(level, u), expected, level.bodies), 1e-14);
  Plan same = plan;
  const auto single = build_hierarchy<float>(problem.network, problem.incidence, problem.dofs, 1, same);
  auto v = make_rows<float>(level.bodies);
  for (std::size_t p = 0; p < u.size(); ++p)
    for (int i = 0; i < 6; ++i) v[p].at[i] = float(u[p].at[i]);
  EXPECT_LT(largest_difference(product(single.levels.front(), v), expected, level.bodies), 2e-6);
}

TEST_F(LevelTest, CoarserProductsAreGalerkins) {
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    Level<double>&fine = hierarchy.levels[l], &coarse = hierarchy.levels[l + 1];
    coarse.x = problem.random_rows<double>(coarse.bodies);
    const std::vector<PartlyHeld> partly_held = std::exchange(fine.partly_held, {});
    move_with_clumps(coarse, fine, 1, 2);
    fine.r = product(fine, fine.e);
    // Above the finest level springs are links; there they are not, and are added by hand.
    std::vector<Spring> springs;
    Halo halo;
    if (l == 0) finest_packing(problem.network, problem.incidence, problem.dofs, springs, halo);
    for (const Spring& spring : springs) {
      const auto row = std::size_t(plan.numbering[0].row[std::size_t(spring.body)]);
      for (int i = 0; i < 6; ++i) fine.r[row].at[i] += spring.stiffness(i, i) * fine.e[row].at[i];
    }
    gather_on_clumps(fine, coarse, 2);
    EXPECT_LT(largest_difference(product(coarse, coarse.x), coarse.r, coarse.bodies), 1e-12) << "level " << l;
    fine.partly_held = partly_held;
  }
}

TEST_F(LevelTest, RigidMotionCostsNothingOnAnyLevel) {
  // Without supports the largest clumps stand for the whole packing moved as one.
  const FreeDofs free =
      number_free_dofs(std::vector<std::uint8_t>(std::size_t(problem.network.bodies), 0x3f));
  Plan all;
  auto loose = build_hierarchy<float>(problem.network, problem.incidence, free, 1, all);
  const std::size_t coarsest = loose.levels.size() - 1;
  ASSERT_GE(coarsest, 2u);
  Level<float>& top = loose.levels[coarsest];
  for (Index p = 0; p < top.bodies; ++p) top.x[std::size_t(p)] = {{1, -2, 3, 0, 0, 0}};
  for (std::size_t l = coarsest; l-- > 0;) {
    Level<float>& level = loose.levels[l];
    move_with_clumps(loose.levels[l + 1], level, 1, 1);
    const auto force = product(level, level.e);
    for (Index p = 0; p < level.bodies; ++p)
      for (int i = 0; i < 6; ++i) EXPECT_EQ(force[std::size_t(p)].at[i], 0) << "level " << l;
    level.x = level.e;
  }
}

TEST_F(LevelTest, InverseBlocksInvertTheDiagonalAndLeaveOutWhatIsHeld) {
  for (Level<double>& level : hierarchy.levels)
    for (Index p = 0; p < level.bodies; p += 5) {
      Matrix6 diagonal, inverse;
      for (int j = 0; j < 6; ++j) {
        auto unit = make_rows<double>(level.bodies), z = unit;
        unit[std::size_t(p)].at[j] = 1;
        const auto column = product(level, unit);
        apply_inverse(level.inverse.data(), level.inverse.size(), unit.front().at, z.front().at);
        for (int i = 0; i < 6; ++i) {
          diagonal(i, j) = column[std::size_t(p)].at[i];
          inverse(i, j) = z[std::size_t(p)].at[i];
        }
      }
      std::uint8_t free = all_free;
      for (const PartlyHeld& body : level.partly_held)
        if (body.row == p) free = body.free;
      Matrix6 expected = Matrix6::Zero();
      for (int i = 0; i < 6; ++i)
        if ((free >> i) & 1) expected(i, i) = 1;
      const Matrix6 found = expected * diagonal * expected * inverse;
      EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-11);
    }
}

TEST_F(LevelTest, SmoothersBoundHolds) {
  // Largest eigenvalue of D^-1 K by the power method: never above 2.
  for (Level<double>& level : hierarchy.levels) {
    auto v = problem.random_rows<double>(level.bodies);
    leave_out_held(level, v);
    double value = 0;
    for (int step = 0; step < 60; ++step) {
      const double size = std::sqrt(dot(v.data(), v.data(), level.bodies));
      for_numbers(0, level.bodies, [&](std::size_t p, int i) { v[p].at[i] /= size; });
      const auto kv = product(level, v);
      apply_inverse(level.inverse.data(), level.inverse.size(), kv.front().at, v.front().at);
      value = std::sqrt(dot(v.data(), v.data(), level.bodies));
    }
    EXPECT_GT(value, 1);
    EXPECT_LE(value, 2 + 1e-12);
  }
}

TEST(InverseBlock, LeavesOutMotionsThatCostNothing) {
  Matrix6 block = Matrix6::Zero();
  const Vector6 across = vector6(1, 1, 0, 0, 0, 0);
  block = 1e6 * across * across.transpose();
  const Matrix6 inverse = inverse_block(block, all_free);
  EXPECT_LT((inverse - block / (4 * 1e12)).cwiseAbs().maxCoeff(), 1e-18);
}

}  // namespace
}  // namespace bondstatic::test
