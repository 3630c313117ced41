#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

using test::cantilever;
using test::Ended;
using test::everything_in;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The number before ",done" at the end of a line, and what stands before it.
std::pair<std::string, double> solved(const std::string& line) {
  const std::size_t status = line.rfind(",done");
  if (status == std::string::npos) return {line, std::nan("")};
  const std::size_t number = line.rfind(',', status - 1);
  return {line.substr(0, number), std::stod(line.substr(number + 1, status - number - 1))};
}

constexpr double tip = -8.534241726238742;

TEST(Sweep, GridRunsOverAllCombinationsTheLastKeyFastest) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended = run_program(
      {"sweep", file, "--vary", "bonds.0.young=200e9,50e9", "--vary", "outputs.0.scale=1e3,-1e3"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 5u) << ended.out;
  EXPECT_EQ(lines[0], "bonds.0.young,outputs.0.scale,particles,bonds,tip,status");
  const std::vector<std::pair<std::string, double>> expected{{"200e9,1e3,11,10", tip},
                                                             {"200e9,-1e3,11,10", -tip},
                                                             {"50e9,1e3,11,10", 4 * tip},
                                                             {"50e9,-1e3,11,10", -4 * tip}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto [point, value] = solved(lines[i + 1]);
    EXPECT_EQ(point, expected[i].first);
    EXPECT_NEAR(value, expected[i].second, 1e-13 * std::abs(expected[i].second));
  }
}

TEST(Sweep, TellsHowManyParticlesAndBondsEachPointHas) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended =
      run_program({"sweep", file, "--vary", "particles.0.line.count:bonds.0.gap=11:0,12:0,11:0.5"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 4u) << ended.out;
  EXPECT_EQ(solved(lines[1]).first, "11,0,11,10");
  EXPECT_EQ(solved(lines[2]).first, "12,0,12,11");
  EXPECT_EQ(solved(lines[3]).first, "11,0.5,11,19") << "neighbours, and theirs";
}

TEST(Sweep, ZippedKeysChangeTogetherAndValuesMayHoldCommas) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended =
      run_program({"sweep", file, "--vary", "loads.0.force:outputs.0.of=[0, -1e5, 0]:uy,[0, 0, -1e5]:uz"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 3u) << ended.out;
  EXPECT_EQ(lines[0], "loads.0.force,outputs.0.of,particles,bonds,tip,status");
  EXPECT_EQ(solved(lines[1]).first, "\"[0, -1e5, 0]\",uy,11,10");
  EXPECT_EQ(solved(lines[2]).first, "\"[0, 0, -1e5]\",uz,11,10");
  EXPECT_NEAR(solved(lines[1]).second, tip, 1e-12);
  EXPECT_NEAR(solved(lines[2]).second, tip, 1e-12);
}

TEST(Sweep, GoesOnAfterFailuresAndEndsWithTheWorst) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever()), out = (scratch / "out").string();
  const Ended ended = run_program({"sweep", file, "--out", out, "--vary", "supports.0.fix=[\"x\"],all,none"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("supports.0.fix=[\"x\"]"));
  EXPECT_THAT(everything_in(out), UnorderedElementsAre("sweep.csv"));
  const auto lines = lines_of(read_text(scratch / "out/sweep.csv"));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1], "\"[\"\"x\"\"]\",11,10,,mechanism");
  EXPECT_NEAR(solved(lines[2]).second, tip, 1e-12);
  EXPECT_EQ(lines[3], "none,,,,invalid-input");
}

TEST(Sweep, InputWrongEverywhereWritesNothing) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended =
      run_program({"sweep", file, "--out", (scratch / "out").string(), "--vary", "bonds.0.yuong=1e9,2e9"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("young"));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

}  // namespace
}  // namespace bondstatic
