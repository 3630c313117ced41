// `bondstatic solve --sensitivities` as a process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SolveSensitivities, AreToldOnTheTerminal) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended = run_program({"solve", file, "--sensitivities"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const char* part :
       {"sensitivity of", "% per %", "young", "4.267121e-11", "-1.0000", "poisson", "radius"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  EXPECT_THAT(run_program({"solve", file}).out, Not(HasSubstr("sensitivity")));
}

TEST(SolveSensitivities, StandInTheSummaryAndInTables) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever()), out = (scratch / "out").string();
  ASSERT_EQ(run_program({"solve", file, "--bond-sensitivities", "--out", out}).code, 0);
  const auto summary = nlohmann::json::parse(read_text(scratch / "out/summary.json"));
  EXPECT_EQ(summary["files"].size(), everything_in(scratch / "out").size());
  const auto tip = summary["outputs"][0];
  const auto young = tip["sensitivities"][0];
  EXPECT_EQ(young["parameter"], "young");
  EXPECT_EQ(young["block"], 0);
  EXPECT_NEAR(young["derivative"].get<double>(), -tip["value"].get<double>() / 200e9, 1e-25);
  EXPECT_NEAR(young["elasticity"].get<double>(), -1, 1e-13);
  EXPECT_THAT(
      read_text(scratch / "out/sensitivities.csv"),
      HasSubstr(
          "output,block,law,parameter,value,derivative,elasticity\ntip,0,timoshenko,young,200000000000,"));
  const std::string by_bond = read_text(scratch / "out/bond_sensitivities.csv");
  EXPECT_THAT(by_bond, HasSubstr("id,a,b,tip per young,tip per poisson,tip per radius\n1,1,2,"));
  EXPECT_EQ(std::count(by_bond.begin(), by_bond.end(), '\n'), 11);

  // Results without sensitivities take the place of those with.
  ASSERT_EQ(run_program({"solve", file, "--out", out}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(scratch / "out/sensitivities.csv"));
}

TEST(SolveSensitivities, NeedOutputs) {
  const ScratchFolder scratch;
  std::string text = cantilever();
  text.resize(text.find("[[outputs]]"));
  const Ended ended = run_program({"solve", scratch.write("case.toml", text), "--sensitivities"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no outputs to differentiate"));
  EXPECT_THAT(ended.err, HasSubstr("add [[outputs]]"));
}

// A particle that nothing holds is left out, and has no displacement to differentiate.
TEST(SolveSensitivities, SayWhatHasNoDerivative) {
  const ScratchFolder scratch;
  const std::string file = scratch.write(
      "case.toml",
      cantilever() +
          "[[outputs]]\nname = \"loose\"\nof = \"uy\"\nat = { id = 12 }\n"
          "[[particles]]\nline = { from = [9, 0, 0], to = [19, 0, 0], count = 2 }\nradius = 0.2\n"
          "[solve]\nunsupported = \"drop\"\n");
  const Ended ended = run_program({"solve", file, "--sensitivities"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("no sensitivities: output \"loose\""));
  EXPECT_THAT(ended.out, HasSubstr("4.267121e-11"));
}

}  // namespace
}  // namespace bondstatic::test
