// Large models are solved in an order of their own; nothing but the time may show it. The other route is
// StaticAnalysis, which keeps the order that is given.
#include <gtest/gtest.h>

#include <algorithm>

#include "bondstatic/mechanism.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/statics.hpp"
#include "support/models.hpp"
#include "support/shuffled.hpp"

namespace bondstatic::test {
namespace {

Model in_any_order(const Model& model) {
  std::mt19937_64 random(9);
  return shuffled(model, random);
}

/// Held at one face, drawn at the other; with pairs beside it that hold on to nothing.
Model large_packing(int loose_pairs) {
  constexpr int edge = 26;
  std::mt19937_64 random(4);
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  const Index packed = Index(model.particles.size());
  for (Index p = 0; p < edge * edge; ++p) {
    fix_all(model, p);
    load(model, packed - 1 - p, vector6(1e3, -2e3, 3e3, 10, 20, 30));
  }
  for (int i = 0; i < loose_pairs; ++i) {
    const Index first = add_particle(model, Vector3(100 + 10 * i, -5 * i, i % 2), 0.5);
    add_bond(model, first, add_particle(model, Vector3(101 + 10 * i, -5 * i, i % 2), 0.5));
  }
  return model;
}

StaticOptions on_two_threads(Unsupported unsupported = Unsupported::error) {
  StaticOptions options;
  options.solver = "multigrid";
  options.threads = 2;
  options.yield_cores = false;  // other tests run at the same time
  options.unsupported = unsupported;
  return options;
}

template <class T>
double largest(const std::vector<T>& of) {
  double size = 0;
  for (const T& v : of) size = std::max(size, v.cwiseAbs().maxCoeff());
  return size;
}

TEST(RenumberedSolve, GivesTheStateOfTheModelAsItIsGiven) {
  const Model model = in_any_order(large_packing(0));
  const StaticSolution solution = solve_statics(model, on_two_threads());
  const LoadCaseResult& found = solution.cases[0];
  EXPECT_EQ(solution.report.phases.front().name, "renumbering");
  const LoadCaseResult expected = StaticAnalysis(model, on_two_threads()).solve().cases[0];
  const double motion = largest(expected.displacement), reaction = largest(expected.reaction);
  ASSERT_EQ(found.displacement.size(), model.particles.size());
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    EXPECT_LT((found.displacement[p] - expected.displacement[p]).cwiseAbs().maxCoeff(), 2e-16 * motion);
    EXPECT_LT((found.reaction[p] - expected.reaction[p]).cwiseAbs().maxCoeff(), 1e-13 * reaction);
  }
  double force = 0;
  for (const BondResult& bond : expected.bonds) force = std::max(force, bond.force.cwiseAbs().maxCoeff());
  ASSERT_EQ(found.bonds.size(), model.bonds.size());
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    EXPECT_LT((found.bonds[k].force - expected.bonds[k].force).cwiseAbs().maxCoeff(), 1e-13 * force);
    EXPECT_NEAR(found.bonds[k].normal_force, expected.bonds[k].normal_force, 1e-13 * force);
  }
  EXPECT_NEAR(found.energy / expected.energy, 1, 1e-15);
}

TEST(RenumberedSolve, NamesMechanismsOfTheModelAsItIsGiven) {
  const Model model = in_any_order(large_packing(3));
  const auto told = [&](auto solve) {
    try {
      solve();
    } catch (const MechanismError& error) {
      std::vector<std::vector<Index>> moving;
      for (const Mechanism& mechanism : error.mechanisms()) moving.push_back(mechanism.particles);
      return std::pair(std::string(error.what()), moving);
    }
    throw std::logic_error("solved floating bodies");
  };
  const auto expected = told([&] { StaticAnalysis(model, on_two_threads()).solve(); });
  EXPECT_EQ(expected.second.size(), 3u);
  EXPECT_EQ(told([&] { solve_statics(model, on_two_threads()); }), expected);
}

TEST(RenumberedSolve, LeavesOutWhatNothingHolds) {
  const Model model = in_any_order(large_packing(3));
  const StaticSolution found = solve_statics(model, on_two_threads(Unsupported::drop));
  const StaticSolution expected = StaticAnalysis(model, on_two_threads(Unsupported::drop)).solve();
  EXPECT_EQ(found.report.dropped.size(), 3u);
  EXPECT_EQ(found.report.dropped, expected.report.dropped);
  for (std::size_t p = 0; p < model.particles.size(); ++p)
    EXPECT_EQ(found.cases[0].displacement[p].hasNaN(), expected.cases[0].displacement[p].hasNaN()) << p;
}

TEST(RenumberedSolve, NamesFaultyBondsInTheOrderOfTheTable) {
  Model model = large_packing(0);
  for (int i = 0; i < 40; ++i) {
    const Index first = add_particle(model, Vector3(50, (7 * i) % 40, 0), 0.5);
    add_bond(model, first, add_particle(model, Vector3(50, (7 * i) % 40, 0), 0.5));
  }
  model = in_any_order(model);
  const auto told = [&](auto solve) -> std::string {
    try {
      solve();
    } catch (const InputError& error) {
      return error.what();
    }
    return "solved";
  };
  const std::string expected = told([&] { bond_properties(model); });
  EXPECT_NE(expected.find("and 20 more faults"), std::string::npos) << expected;
  EXPECT_EQ(told([&] { solve_statics(model, on_two_threads()); }), expected);
}

}  // namespace
}  // namespace bondstatic::test
