// What a static solve promises beside its numbers: threads, memory, load cases, bodies left out, failures.
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/error.hpp"
#include "bondstatic/mechanism.hpp"
#include "bondstatic/statics.hpp"
#include "multigrid/hard_models.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

BondBlock beam() {
  return block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}});
}

Model loaded_packing(int edge) {
  std::mt19937_64 random(11);
  Model model = random_packing(random, edge, beam());
  const Index last = Index(model.particles.size()) - 1;
  for (Index p = 0; p < edge * edge; ++p) fix_all(model, p);
  load(model, last, vector6(1e3, -2e3, 3e3, 10, 20, 30));
  return model;
}

bool same_bits(const LoadCaseResult& a, const LoadCaseResult& b) {
  for (std::size_t p = 0; p < a.displacement.size(); ++p)
    if (a.displacement[p] != b.displacement[p] || a.reaction[p] != b.reaction[p]) return false;
  for (std::size_t k = 0; k < a.bonds.size(); ++k)
    if (a.bonds[k].force != b.bonds[k].force || a.bonds[k].energy != b.bonds[k].energy) return false;
  return true;
}

StaticOptions with(const std::string& solver, int threads) {
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  options.yield_cores = false;  // other tests run at the same time
  return options;
}

TEST(StaticSolve, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Model model = loaded_packing(17);  // loops long enough to be shared out
  const auto one = solve_statics(model, with("auto", 1)).cases[0];
  for (const int threads : {2, 3, 4}) {
    const auto other = solve_statics(model, with("auto", threads)).cases[0];
    EXPECT_TRUE(same_bits(one, other)) << threads << " threads";
  }
}

// Direct solvers are refined until nothing changes; iterative ones until nothing changes that a double of the
// size of the largest displacement shows.
TEST(StaticSolve, GivesTheSameAnswerFromEverySolver) {
  const Model model = loaded_packing(5);
  const auto reference = solve_statics(model, {}).cases[0];
  double largest = 0;
  for (const Vector6& u : reference.displacement) largest = std::max(largest, u.cwiseAbs().maxCoeff());
  for (const SolverInfo& info : available_solvers()) {
    const auto solution = solve_statics(model, with(info.name, 1));
    if (solution.report.iterations == 0) {
      EXPECT_TRUE(same_bits(reference, solution.cases[0])) << info.name;
      continue;
    }
    for (std::size_t p = 0; p < reference.displacement.size(); ++p)
      EXPECT_LT((solution.cases[0].displacement[p] - reference.displacement[p]).cwiseAbs().maxCoeff(),
                2e-16 * largest)
          << info.name << ", particle " << p;
  }
}

TEST(StaticSolve, AutoSaysWhatItChoseAndWhy) {
  const auto small = solve_statics(loaded_packing(4), {}).report;
  EXPECT_EQ(small.solver, available_solvers().front().name);
  EXPECT_NE(small.solver_reason.find("particles"), std::string::npos);
  const auto large = solve_statics(loaded_packing(15), {}).report;
  EXPECT_EQ(large.solver, "multigrid");
  EXPECT_NE(large.solver_reason.find("predicted"), std::string::npos) << large.solver_reason;
  EXPECT_EQ(solve_statics(loaded_packing(4), with("multigrid", 1)).report.solver_reason, "");
}

TEST(StaticSolve, AutoTellsWallsAndChainsFromPackings) {
  std::mt19937_64 random(1);
  const auto chosen = [&](const test::HardModel& of) {
    return solve_statics(hard_model(random, of), with("auto", 1)).report;
  };
  const StaticReport wall = chosen({.count = {60, 1, 60}});
  EXPECT_EQ(wall.solver, available_solvers().front().name) << wall.solver_reason;
  const StaticReport chain = chosen({.count = {1, 1, 4000}});
  EXPECT_EQ(chain.solver, available_solvers().front().name) << chain.solver_reason;
  const StaticReport packing = chosen({.count = {16, 16, 16}});
  EXPECT_EQ(packing.solver, "multigrid");
  EXPECT_EQ(packing.analysis.factor_entries, 0) << "no direct solver was asked";
}

TEST(StaticSolve, ADirectSolverTakesOverWhereMultigridDoesNotConverge) {
  std::mt19937_64 random(7);
  const Model model = hard_model(random, {.count = {13, 13, 13}, .decades = 14});
  EXPECT_THROW(solve_statics(model, with("multigrid", 1)), AccuracyError);
  const StaticReport report = solve_statics(model, with("auto", 1)).report;
  EXPECT_EQ(report.solver, available_solvers().front().name);
  EXPECT_NE(report.solver_reason.find("multigrid did not converge"), std::string::npos);
  ASSERT_FALSE(report.warnings.empty());
}

TEST(StaticSolve, NamesTheAlternativeWhereASolverDoesNotFit) {
  StaticOptions options = with(available_solvers().front().name, 1);
  options.memory_limit = 1e7;
  try {
    solve_statics(loaded_packing(14), options);
    FAIL() << "solved within ten megabytes";
  } catch (const MemoryError& error) {
    EXPECT_NE(std::string(error.what()).find("--solver multigrid needs"), std::string::npos) << error.what();
  }
}

TEST(StaticSolve, SharesOneFactorisationBetweenLoadCases) {
  Model model = loaded_packing(3);
  model.load_cases = {"one", "two", "three"};
  model.loads.clear();
  for (Index c = 0; c < 3; ++c) load(model, 26, vector6(1, double(c), 0), c);
  const auto solution = solve_statics(model, {});
  EXPECT_EQ(solution.report.factorisations, 1);
  ASSERT_EQ(solution.cases.size(), 3u);
  EXPECT_EQ(solution.cases[1].name, "two");

  model.supports.push_back({20, {true, true, true, true, true, true}, Vector6::Zero(), 2});
  const auto held = solve_statics(model, {});
  EXPECT_EQ(held.report.factorisations, 2);
  EXPECT_TRUE(same_bits(held.cases[0], solution.cases[0]));
  EXPECT_TRUE(held.cases[2].displacement[20].isZero(0));
}

TEST(StaticSolve, PrescribedMotionDoesWork) {
  Model model = chain(beam(), Vector3::Zero(), Vector3(1, 0, 0), 4, 0.125);
  model.supports.push_back({4, {true, false, false, false, false, false}, vector6(1e-3, 0, 0), every_case});
  const auto result = solve_statics(model, {}).cases[0];
  for (Index i = 0; i <= 4; ++i)
    EXPECT_NEAR(result.displacement[std::size_t(i)][0], 1e-3 * double(i) / 4, 1e-18);
  const double force = 5e9 * 3.14159265358979323846 * 0.125 * 0.125 * 1e-3;
  EXPECT_NEAR(result.reaction[4][0] / force, 1, 1e-15);
  EXPECT_NEAR(result.reaction[0][0] / force, -1, 1e-15);
  EXPECT_NEAR(result.energy / (0.5 * force * 1e-3), 1, 1e-15);
  EXPECT_NEAR(result.work / (force * 1e-3), 1, 1e-15);
  EXPECT_NEAR(result.bonds[2].normal_force / force, 1, 1e-15);
}

TEST(StaticSolve, WholeModelHeldNeedsNoSolver) {
  Model model = chain(beam(), Vector3::Zero(), Vector3(1, 0, 0), 1, 0.5);
  fix_all(model, 1, vector6(0, 0, 0, 1e-3, 0, 0));
  const auto solution = solve_statics(model, {});
  EXPECT_EQ(solution.report.factorisations, 0);
  EXPECT_LT(solution.cases[0].bonds[0].twisting_moment, 0);  // the bond turns particle b back
  EXPECT_NEAR(solution.cases[0].reaction[1][3] / solution.cases[0].reaction[0][3], -1, 1e-15);
}

TEST(StaticSolve, RefusesWhatDoesNotFitBeforeItFails) {
  StaticOptions options;
  options.memory_limit = 1e5;
  try {
    solve_statics(loaded_packing(6), options);
    FAIL() << "solved within a tenth of a megabyte";
  } catch (const MemoryError& error) {
    EXPECT_EQ(error.code(), ExitCode::out_of_memory);
    EXPECT_NE(std::string(error.what()).find("100 kB are at hand"), std::string::npos) << error.what();
  }
}

Model with_rattlers() {
  Model model = loaded_packing(3);
  add_particle(model, Vector3(10, 0, 0), 0.5);
  add_particle(model, Vector3(20, 0, 0), 0.5);
  add_particle(model, Vector3(21, 0, 0), 0.5);
  add_bond(model, 28, 29);
  load(model, 29, vector6(0, 0, -7));
  return model;
}

TEST(StaticSolve, NamesUnsupportedBodies) {
  try {
    solve_statics(with_rattlers(), {});
    FAIL() << "solved a floating body";
  } catch (const MechanismError& error) {
    EXPECT_EQ(error.mechanisms().size(), 2u);
    EXPECT_NE(std::string(error.what()).find("28"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("29, 30"), std::string::npos) << error.what();
  }
}

TEST(StaticSolve, LeavesOutUnsupportedBodiesWhereAskedAndSaysSo) {
  StaticOptions options;
  options.unsupported = Unsupported::drop;
  const auto solution = solve_statics(with_rattlers(), options);
  const std::vector<std::vector<Index>> dropped{{28}, {29, 30}};  // by id
  EXPECT_EQ(solution.report.dropped, dropped);
  ASSERT_EQ(solution.report.warnings.size(), 1u);
  EXPECT_NE(solution.report.warnings[0].find("1 dropped particles"), std::string::npos)
      << solution.report.warnings[0];
  EXPECT_NE(solution.report.warnings[0].find("-7"), std::string::npos) << solution.report.warnings[0];
  EXPECT_TRUE(std::isnan(solution.cases[0].displacement[28][0]));
  EXPECT_TRUE(std::isnan(solution.cases[0].bonds.back().normal_force));
  const auto alone = solve_statics(loaded_packing(3), {}).cases[0];
  for (std::size_t p = 0; p < alone.displacement.size(); ++p)
    EXPECT_EQ(solution.cases[0].displacement[p], alone.displacement[p]);
}

TEST(StaticSolve, NothingSupportedIsAnErrorEvenWhereDroppingIsAllowed) {
  Model model = loaded_packing(2);
  model.supports.clear();
  StaticOptions options;
  options.unsupported = Unsupported::drop;
  EXPECT_THROW(solve_statics(model, options), MechanismError);
}

TEST(StaticSolve, ConflictingSupportsAreAnError) {
  Model model = loaded_packing(2);
  fix_all(model, 0, vector6(1e-3, 0, 0));
  EXPECT_THROW(solve_statics(model, {}), Error);
}

// Two bonds in parallel to the ground, one of them 10^20 times stiffer in a direction that the load does not
// need is fine; a chain hanging by a bond that vanishes in the rounding of its neighbours' stiffness is not.
TEST(StaticSolve, NumericallySingularEndsAsAccuracyError) {
  Model model;
  model.blocks = {block("generic", {{"kn", 1e-12}, {"ks", 1e-12}, {"kt", 1e-12}, {"kb", 1e-12}}),
                  block("generic", {{"kn", 1e12}, {"ks", 1e12}, {"kt", 1e12}, {"kb", 1e12}})};
  for (int i = 0; i < 4; ++i) add_particle(model, Vector3(0.3 * i, 0.2 * i, 0.1 * i), 0.2);
  add_bond(model, 0, 1, 0);
  add_bond(model, 1, 2, 1);
  add_bond(model, 2, 3, 1);
  fix_all(model, 0);
  load(model, 3, vector6(1, 1, 1));
  for (const SolverInfo& info : available_solvers())
    EXPECT_THROW(solve_statics(model, with(info.name, 1)), AccuracyError) << info.name;
}

}  // namespace
}  // namespace bondstatic::test
