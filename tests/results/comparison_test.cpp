// A comparison's files.
#include "results/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/runs.hpp"
#include "io/read_by_vtk.hpp"
#include "support/periodic.hpp"

namespace bondstatic::test {
namespace {

TEST(ComparisonResults, RunAndAnswerGoOnAlikeAcrossPeriodicFaces) {
  std::mt19937_64 random(11);
  Model model =
      periodic_packing(random, 3, block("generic", {{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}}));
  model.load_cases = {""};
  model.strains.resize(1);
  const StaticSolution solution = solve_statics(model, direct());
  const State& statics = solution.cases.front();
  const RunState run = ended_in(statics);
  const std::vector<Comparison> steps{compare(model, statics, 0, run, direct())};
  const ScratchFolder scratch;
  write_comparison({model, statics, run, solution.report, steps}, {}, (scratch / "out").string());
  auto grid = read_by_vtk((scratch / "out/model.vtu").string(), scratch);
  EXPECT_GT(std::stoul(grid["points"]), model.particles.size());
  ASSERT_FALSE(grid["array point displacement"].empty());
  EXPECT_EQ(grid["array point run_displacement"], grid["array point displacement"]);
  EXPECT_EQ(grid["array point displacement_difference"].find_first_of("123456789", 2), std::string::npos);
}

}  // namespace
}  // namespace bondstatic::test
