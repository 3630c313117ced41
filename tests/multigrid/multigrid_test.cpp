// The multigrid as a solver: the direct solver's answer to the last digit, or exit 4.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bondstatic/error.hpp"
#include "bondstatic/statics.hpp"
#include "multigrid/hard_models.hpp"

namespace bondstatic::test {
namespace {

StaticSolution solved(const Model& model, const std::string& solver, int threads = 1) {
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  options.yield_cores = false;
  return solve_statics(model, options);
}

/// Largest differences relative to the largest values: displacements (rotations in the model's unit of
/// length), bond forces.
struct Apart {
  double displacement = 0, force = 0;
};
Apart apart(const StaticSolution& a, const StaticSolution& b) {
  Apart result;
  for (std::size_t c = 0; c < a.cases.size(); ++c) {
    double u = 0, f = 0, du = 0, df = 0;
    for (std::size_t p = 0; p < a.cases[c].displacement.size(); ++p) {
      u = std::max(u, a.cases[c].displacement[p].cwiseAbs().maxCoeff());
      du = std::max(du, (a.cases[c].displacement[p] - b.cases[c].displacement[p]).cwiseAbs().maxCoeff());
    }
    for (std::size_t k = 0; k < a.cases[c].bonds.size(); ++k) {
      f = std::max(f, a.cases[c].bonds[k].force.head<3>().cwiseAbs().maxCoeff());
      df = std::max(df,
                    (a.cases[c].bonds[k].force - b.cases[c].bonds[k].force).head<3>().cwiseAbs().maxCoeff());
    }
    result.displacement = std::max(result.displacement, du / u);
    result.force = std::max(result.force, df / f);
  }
  return result;
}

/// Rounds end where the last digit of a double stands: both solvers' answers are rounded once.
void expect_same(const Model& model, const std::string& what) {
  const StaticSolution direct = solved(model, "cholmod"), iterative = solved(model, "multigrid");
  const Apart found = apart(direct, iterative);
  EXPECT_LT(found.displacement, 3e-16) << what;
  EXPECT_LT(found.force, 1e-13) << what;
  for (const LoadCaseResult& result : iterative.cases) {
    EXPECT_LT(result.accuracy.backward_error, 1e-15) << what;
    EXPECT_LT(result.accuracy.forward_error, 3e-16) << what;
  }
  EXPECT_GT(iterative.report.iterations, 0) << what;
}

TEST(Multigrid, AgreesWithTheDirectSolverOnWhatPackingsHave) {
  std::mt19937_64 random(1);
  expect_same(hard_model(random, {}), "a plain block");
  expect_same(hard_model(random, {.decades = 6}), "stiffness over six decades");
  expect_same(hard_model(random, {.hinges = 0.5}), "half of the cross bonds without moments");
  expect_same(hard_model(random, {.count = {3, 3, 300}}), "a slender body");
  expect_same(hard_model(random, {.count = {20, 2, 20}}), "a thin wall");
  expect_same(hard_model(random, {.bodies = 4}), "four bodies");
  expect_same(hard_model(random, {.size_ratio = 10}), "particles 10:1");
}

TEST(Multigrid, TakesPrescribedMotionRollersAndManyLoadCases) {
  std::mt19937_64 random(2);
  Model model = random_packing(random, 8, block("timoshenko", {{"young", 2e9}, {"poisson", 0.3}}));
  model.load_cases = {"pushed", "turned", "pulled", "nothing"};
  for (Index p = 0; p < 64; ++p)
    model.supports.push_back({p, {true, false, false, false, false, false}, Vector6::Zero(), every_case});
  model.supports.push_back({0, {false, true, true, true, false, false}, Vector6::Zero(), every_case});
  model.supports.push_back({63, {false, true, true, false, false, false}, Vector6::Zero(), every_case});
  for (Index p = 448; p < 512; ++p)
    model.supports.push_back(
        {p, {true, false, false, false, false, false}, vector6(-1e-3, 0, 0), every_case});
  load(model, 300, vector6(0, 1e3, 2e3), 0);
  load(model, 301, vector6(0, 0, 0, 1e2, 0, 0), 1);
  load(model, 302, vector6(5e3, 0, 0), 2);
  expect_same(model, "rollers");
}

TEST(Multigrid, SmallModelsAreSolvedAtOnce) {
  Model model = chain(block("timoshenko", {{"young", 1e10}, {"poisson", 0.25}, {"radius", 0.01}}),
                      Vector3::Zero(), Vector3(1, 0, 0), 10, 0.05);
  load(model, 10, vector6(0, 10, 0));
  expect_same(model, "a chain of ten");
  EXPECT_LE(solved(model, "multigrid").report.iterations, 10);
}

// Ten repeats where BONDSTATIC_FULL is set, one on each number of threads by default.
TEST(Multigrid, SameBitsOnAnyNumberOfThreadsAndEachTime) {
  std::mt19937_64 random(3);
  const Model model = hard_model(random, {.count = {21, 21, 21}, .decades = 1});
  const StaticSolution one = solved(model, "multigrid");
  const int repeats = std::getenv("BONDSTATIC_FULL") ? 10 : 3;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const StaticSolution other = solved(model, "multigrid", 2 + repeat % 3);
    EXPECT_EQ(other.report.iterations, one.report.iterations);
    for (std::size_t p = 0; p < model.particles.size(); ++p)
      for (int i = 0; i < 6; ++i)
        ASSERT_EQ(other.cases[0].displacement[p][i], one.cases[0].displacement[p][i]) << p;
  }
}

TEST(Multigrid, GoesOverToDoubleWhereFloatDoesNotDoAndSaysSo) {
  std::mt19937_64 random(4);
  const Model model = hard_model(random, {.count = {27, 1, 20}, .size_ratio = 9});
  expect_same(model, "a wall of one layer");
  const StaticSolution solution = solved(model, "multigrid");
  ASSERT_FALSE(solution.report.warnings.empty());
  EXPECT_NE(solution.report.warnings.front().find("double precision"), std::string::npos);
}

TEST(Multigrid, IterationsStayFlatAsThePackingGrows) {
  std::mt19937_64 random(5);
  std::vector<Index> iterations;
  for (const Index edge : {8, 16, 24})
    iterations.push_back(
        solved(hard_model(random, {.count = {edge, edge, edge}}), "multigrid").report.iterations);
  EXPECT_LE(double(iterations[2]), 1.25 * double(iterations[1])) << iterations[1] << " " << iterations[2];
  EXPECT_LE(iterations[2], 80);
}

// Whether the hard model of that seed has an answer; then it must be the right one.
bool ends_right(int seed) {
  SCOPED_TRACE(seed);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const HardModel of = any_hard_model(random);
  const Model model = hard_model(random, of);
  try {
    const StaticSolution iterative = solved(model, "multigrid");
    const Apart found = apart(solved(model, "cholmod"), iterative);
    EXPECT_LT(found.displacement, 3e-16);
    // Differences of displacements a million times as large in the slenderest.
    EXPECT_LT(found.force, 1e-11);
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_accurate) << error.what();
    return false;
  }
}

// 200 models with contrast to 10^8 and aspect to 400 where BONDSTATIC_FULL is set, 20 by default.
TEST(MultigridCampaign, HardModelsEndRightOrWithExitFour) {
  const int models = std::getenv("BONDSTATIC_FULL") ? 200 : 20;
  int right = 0;
  for (int seed = 0; seed < models; ++seed) right += ends_right(seed);
  EXPECT_GE(right, models * 9 / 10);
}

// Seven rounds contract by 0.1 to 0.9, the eighth to 8e-5: what is left is more than that part of it.
TEST(Multigrid, DoesNotTrustASingleContraction) {
  EXPECT_TRUE(ends_right(144));
}

}  // namespace
}  // namespace bondstatic::test
