// The checkpoint that a run leaves where it is not at rest when its steps are spent, and going on from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/relax_cases.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::checkpoint_name;
using test::Ended;
using test::everything_in;
using test::heavy_cantilever;
using test::read_json;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class RelaxCheckpoint : public testing::Test {
 protected:
  ScratchFolder scratch;
  std::string file = scratch.write("case.toml", heavy_cantilever());
  std::string out = (scratch / "out").string();
  fs::path checkpoint = scratch / "out" / checkpoint_name;

  Ended relax(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"relax", file, "--threads", "1", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  Ended stopped_early() const { return relax({"--set", "dynamics.max_steps=5000"}); }

  void expect_refused(const std::vector<std::string>& more, const std::string& said) const {
    const std::string before = read_text(checkpoint);
    const auto results = test::results_in(out);
    const Ended ended = relax(more);
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr(checkpoint.string() + ": "));
    EXPECT_THAT(ended.err, HasSubstr(said));
    EXPECT_THAT(ended.err, HasSubstr("cure: "));
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_TRUE(read_text(checkpoint) == before);
    test::expect_same_results(test::results_in(out), results);
  }
};

TEST_F(RelaxCheckpoint, IsKeptBesideTheResultsOfARunThatIsNotAtRest) {
  const Ended ended = stopped_early();
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.out, HasSubstr("not at rest after 5000 steps"));
  for (const char* part : {"the run is not at rest after 5000 steps: fastest particle",
                           "cure: raise max_steps", "go on with --resume"})
    EXPECT_THAT(ended.err, HasSubstr(part));
  EXPECT_THAT(everything_in(out), Contains(checkpoint_name));
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["at_rest"], false);
  EXPECT_EQ(summary["load_cases"][0]["end"], "step limit");
  EXPECT_EQ(summary["load_cases"][0]["steps"], 5000);
  EXPECT_THAT(summary["files"], Not(Contains(checkpoint_name)));
}

TEST_F(RelaxCheckpoint, IsGoneOnceTheRunIsAtRest) {
  ASSERT_EQ(stopped_early().code, 4);
  ASSERT_EQ(relax({"--resume", "--set", "dynamics.max_steps=6000"}).code, 4);
  const Ended ended = relax({"--resume", "--set", "dynamics.max_steps=1000000"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["at_rest"], true);
  EXPECT_EQ(summary["files"].get<std::set<std::string>>(), everything_in(out));
}

TEST_F(RelaxCheckpoint, LeadsToTheRunWithoutAStop) {
  const std::string whole = (scratch / "whole").string();
  ASSERT_EQ(run_program({"relax", file, "--threads", "1", "--out", whole}).code, 0);
  const auto expected = test::results_in(whole);
  // The run looks around after a fixed number of steps, the second row of the history tells how many: stops
  // at such a look, between two, and while the run holds still to be taken for at rest.
  const std::string history = expected.at("history.csv");
  const std::size_t second = history.find('\n', history.find('\n') + 1) + 1;
  const long stretch = std::stol(history.substr(second));
  const long all = nlohmann::json::parse(expected.at("summary.json"))["load_cases"][0]["steps"].get<long>();
  for (const long steps : {40 * stretch, 50 * stretch + 1, all - 5 * stretch - 1, all - 1}) {
    SCOPED_TRACE(steps);
    ASSERT_EQ(relax({"--set", "dynamics.max_steps=" + std::to_string(steps)}).code, 4);
    ASSERT_EQ(relax({"--resume"}).code, 0);
    test::expect_same_results(test::results_in(out), expected);
  }
}

TEST_F(RelaxCheckpoint, WithoutMoreStepsLeadsToTheSameResultsAndWarnings) {
  // Above the critical time step, which is worth a warning, for too few steps to blow up.
  const std::vector<std::string> set{"--set", "dynamics.max_steps=200", "--set", "dynamics.time_step=5.1e-5"};
  ASSERT_EQ(relax(set).code, 4);
  const auto before = test::results_in(out);
  ASSERT_THAT(before.at("summary.json"), HasSubstr("may blow up"));
  ASSERT_EQ(relax({"--resume", set[0], set[1], set[2], set[3]}).code, 4);
  auto after = test::results_in(out);
  after[checkpoint_name] = before.at(checkpoint_name);  // knows how long the run took
  test::expect_same_results(after, before);
}

TEST_F(RelaxCheckpoint, OfSeveralLoadCasesKnowsAllOfThem) {
  scratch.write("case.toml", test::two_load_cases());
  const Ended ended = stopped_early();
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("load case down is not at rest after 5000 steps"));
  ASSERT_EQ(relax({"--resume"}).code, 0);
  EXPECT_EQ(read_json(scratch / "out/summary.json")["at_rest"], true);
  EXPECT_FALSE(fs::exists(checkpoint));
}

TEST_F(RelaxCheckpoint, LyingThereUnaskedIsAnError) {
  ASSERT_EQ(stopped_early().code, 4);
  expect_refused({}, "add --resume to go on with it, or remove the file");
}

TEST_F(RelaxCheckpoint, OfAnotherModelIsRefused) {
  ASSERT_EQ(stopped_early().code, 4);
  for (const char* set : {"bonds.0.young=70e9", "particles.0.density=7851", "loads.0.force=[0, -1e3, 0]",
                          "dynamics.kinematics=small", "dynamics.ramp_time=0.1"})
    expect_refused({"--resume", "--set", set}, "belongs to another model");
}

TEST_F(RelaxCheckpoint, WithOtherOutputsIsRefused) {
  ASSERT_EQ(stopped_early().code, 4);
  expect_refused({"--resume", "--set", "outputs.0.name=\"other\""}, "other outputs");
  const std::string more =
      heavy_cantilever() + "[[outputs]]\nname = \"along\"\nof = \"ux\"\nat = { id = 11 }\n";
  scratch.write("case.toml", more);
  expect_refused({"--resume"}, "other outputs");
  scratch.write("case.toml", more.substr(0, more.find("[[outputs]]")));
  expect_refused({"--resume"}, "other outputs");
}

TEST_F(RelaxCheckpoint, ThatIsDamagedIsRefused) {
  ASSERT_EQ(stopped_early().code, 4);
  const std::string sound = read_text(checkpoint);
  std::string flipped = sound;
  flipped[flipped.size() / 2] = char(flipped[flipped.size() / 2] ^ 1);
  scratch.write("out/relax.checkpoint", flipped);
  expect_refused({"--resume"}, "is damaged: its checksum");
  scratch.write("out/relax.checkpoint", sound.substr(0, sound.size() - 1));
  expect_refused({"--resume"}, "is damaged: it should hold");
  scratch.write("out/relax.checkpoint", "notes of mine");
  expect_refused({"--resume"}, "is no checkpoint");
}

TEST_F(RelaxCheckpoint, ThatIsMissingMeansFromTheBeginning) {
  const Ended ended = relax({"--resume"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, checkpoint.string() + ": not there, starting from the beginning\n");
  EXPECT_EQ(read_json(scratch / "out/summary.json")["at_rest"], true);
}

TEST_F(RelaxCheckpoint, IsSoughtBesideTheResultsOnly) {
  const Ended ended = run_program({"relax", file, "--resume"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--resume without --out"));
  EXPECT_THAT(ended.out, IsEmpty());
}

TEST_F(RelaxCheckpoint, HalfReplacedByAKilledRunLeavesNothing) {
  ASSERT_EQ(stopped_early().code, 4);
  scratch.write("out/.relax.checkpoint.new", read_text(checkpoint));
  scratch.write("out/.relax.checkpoint.part", "bondst");
  ASSERT_EQ(relax({"--resume"}).code, 0);
  EXPECT_THAT(everything_in(out), testing::SizeIs(6));
}

}  // namespace
}  // namespace bondstatic
