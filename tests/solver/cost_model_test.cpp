// What a solve is predicted to take, and the choice that follows.
#include "solver/cost_model.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bondstatic::test {
namespace {

const std::vector<Candidate> two{{"direct", {10, 2e9}}, {"iterative", {40, 3e8}}};

bool says(const Choice& choice, const std::string& text) {
  return choice.reason.find(text) != std::string::npos;
}

TEST(SolverChoice, TakesTheFastestThatFits) {
  const Choice choice = choose_solver(two, 4e9);
  EXPECT_EQ(choice.solver, "direct");
  EXPECT_TRUE(choice.fits);
}

TEST(SolverChoice, TakesTheSlowerWhereTheFastestDoesNotFitAndSaysSo) {
  const Choice choice = choose_solver(two, 1e9);
  EXPECT_EQ(choice.solver, "iterative");
  EXPECT_TRUE(choice.fits);
  EXPECT_TRUE(says(choice, "iterative: predicted 40 s and 300 MB")) << choice.reason;
  EXPECT_TRUE(says(choice, "direct 10 s and 2 GB of 1 GB at hand")) << choice.reason;
}

TEST(SolverChoice, NamesTheLeastHungryWhereNothingFits) {
  const Choice choice = choose_solver(two, 1e8);
  EXPECT_EQ(choice.solver, "iterative");
  EXPECT_FALSE(choice.fits);
  EXPECT_TRUE(says(choice, "300 MB")) << choice.reason;
  EXPECT_TRUE(says(choice, "100 MB are at hand")) << choice.reason;
}

TEST(SolverChoice, EqualTimesGoToTheEarlier) {
  const std::vector<Candidate> equal{{"first", {1, 2e6}}, {"second", {1, 1e6}}};
  EXPECT_EQ(choose_solver(equal, 1e9).solver, "first");
  EXPECT_EQ(choose_solver(equal, 1.5e6).solver, "second");
}

TEST(SolverChoice, ExactFitFits) {
  EXPECT_TRUE(choose_solver(std::vector<Candidate>{{"only", {1, 1e6}}}, 1e6).fits);
}

TEST(SolverChoice, ADoubtfulPredictionMustPromiseMore) {
  std::vector<Candidate> pair{{"sure", {1.5, 1e9}}, {"doubtful", {1, 1e6}, 2}};
  EXPECT_EQ(choose_solver(pair, 1e10).solver, "sure");
  pair.front().cost.seconds = 2.5;
  EXPECT_EQ(choose_solver(pair, 1e10).solver, "doubtful");
  EXPECT_EQ(choose_solver(pair, 1e8).solver, "doubtful");
}

TEST(Cost, CountsBeyondThirtyTwoBits) {
  AnalysisReport report;
  report.factor_entries = Index(1) << 34;
  report.matrix_entries = Index(1) << 33;
  EXPECT_EQ(direct_cost(report, {0, 1, 1, 0}, 1).seconds, 0x1p34 + 0x1p33);
  const Cost cost = linear_cost(Index(1) << 32, Index(1) << 34, {1, 2, 3, 4, 0}, 1);
  EXPECT_EQ(cost.seconds, 0x1p32 + 2 * 0x1p34);
  EXPECT_EQ(cost.bytes, 3 * 0x1p32 + 4 * 0x1p34);
}

TEST(SolverChoice, NoCandidateIsAnError) {
  EXPECT_THROW(choose_solver({}, 1e9), std::invalid_argument);
}

TEST(CostModel, DirectCostIsTheSumOfItsParts) {
  AnalysisReport analysis;
  analysis.factor_flops = 8e9;
  analysis.factor_entries = 1000;
  analysis.matrix_entries = 100;
  analysis.predicted_bytes = 12345;
  const DirectRates rates{1e-9, 1e-3, 1e-2, 0.5};
  EXPECT_DOUBLE_EQ(direct_cost(analysis, rates, 1).seconds, 8 + 1 + 1);
  EXPECT_DOUBLE_EQ(direct_cost(analysis, rates, 4).seconds, 4 + 1 + 1);
  EXPECT_EQ(direct_cost(analysis, rates, 1).bytes, 12345);
}

TEST(CostModel, LinearCostGrowsWithBodiesAndLinks) {
  const LinearRates rates{1e-5, 1e-6, 1000, 100, 0.5};
  const Cost one = linear_cost(1000, 3000, rates, 1);
  EXPECT_DOUBLE_EQ(one.seconds, 0.013);
  EXPECT_DOUBLE_EQ(one.bytes, 1.3e6);
  EXPECT_DOUBLE_EQ(linear_cost(1000, 3000, rates, 4).seconds, 0.0065);
  EXPECT_DOUBLE_EQ(linear_cost(2000, 6000, rates, 1).seconds, 2 * one.seconds);
}

// The index arithmetic beyond 2^31: a packing of 10^10 bodies.
TEST(CostModel, CountsPastTheReachOf32Bits) {
  const LinearRates rates{0, 0, 1, 1, 1};
  EXPECT_EQ(linear_cost(10'000'000'000, 30'000'000'000, rates, 1).bytes, 4e10);
}

}  // namespace
}  // namespace bondstatic::test
