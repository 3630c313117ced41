// Runs of fracture that are stopped and resumed, or killed at any moment and resumed, end with the bits of
// one that was left alone. BONDSTATIC_FULL=1 kills 50 times instead of 3.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "app/fracture_cases.hpp"
#include "io/archive.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::everything_in;
using test::expect_same_results;
using test::fracture_results_in;
using test::Program;
using test::read_json;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Results = std::map<std::string, std::string>;
using Seconds = std::chrono::duration<double>;

std::vector<std::string> arguments_of(const std::string& file, const fs::path& out,
                                      const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"fracture", file, "--out", out.string(), "--threads", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// A run that is on its way: it has shown its first state, at its first break.
bool under_way(const fs::path& out) {
  return fs::exists(out / test::unfinished / "fracture_0000.vtu");
}

class InterruptedFracture : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(InterruptedFracture, TellsWhatItFoundKeepsTheRunAndResumesToTheSameBits) {
  const auto [signal, code] = GetParam();
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::pulled_block());
  ASSERT_EQ(run_program(arguments_of(file, scratch / "whole")).code, 0);
  Program program(arguments_of(file, scratch / "out"));
  while (program.running() && !under_way(scratch / "out")) std::this_thread::yield();
  program.send(signal);
  const Ended ended = program.end();
  ASSERT_EQ(ended.code, code) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("first break"));
  EXPECT_THAT(ended.out, HasSubstr("interrupted"));
  EXPECT_THAT(ended.err, HasSubstr("keeps the run, go on with --resume"));
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["end"], "interrupted");
  EXPECT_GE(summary["breaks"].get<int>(), 1);
  EXPECT_THAT(everything_in(scratch / "out"), Contains(test::fracture_checkpoint));

  const Ended unasked = run_program(arguments_of(file, scratch / "out"));
  EXPECT_EQ(unasked.code, 2);
  EXPECT_THAT(unasked.err, HasSubstr("add --resume"));
  const Ended resumed = run_program(arguments_of(file, scratch / "out", {"--resume"}));
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  expect_same_results(fracture_results_in(scratch / "out"), fracture_results_in(scratch / "whole"));
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedFracture,
                         testing::Values(std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}),
                         [](const auto& one) {
                           return std::string(one.param.first == SIGINT ? "INT" : "TERM");
                         });

/// After a kill: results are whole, and of this case or of the one before; so is the checkpoint.
void expect_nothing_partial(const fs::path& folder, const Results& old, const Results& fresh) {
  if (!fs::exists(folder)) return;
  bool all_old = true, all_fresh = true;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".bondstatic-") || name == test::unfinished) continue;
    if (name.ends_with("checkpoint") || name.ends_with("checkpoint.new")) {
      EXPECT_NO_THROW(Archive({"fracture checkpoint", 1}, read_text(entry.path()), name)) << name;
      continue;
    }
    const std::string text = read_text(entry.path());
    const std::string content = name == "summary.json" ? test::comparable(text) : text;
    const auto is_of = [&](const Results& results) {
      return results.contains(name) && content == results.at(name);
    };
    all_old = all_old && is_of(old);
    all_fresh = all_fresh && is_of(fresh);
    EXPECT_TRUE(all_old || all_fresh) << name << " is not of the run that the others are of";
  }
}

TEST(KilledFracture, AtAnyMomentResumesToTheSameBitsAndLeavesNothingPartial) {
  const int kills = test::full_run() ? 50 : 3;
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::pulled_block());
  const std::string before = scratch.write("before.toml", test::fibre_bundle());
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(arguments_of(file, scratch / "whole")).code, 0);
  const Seconds whole = std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(run_program(arguments_of(before, scratch / "earlier")).code, 0);
  const Results fresh = fracture_results_in(scratch / "whole"),
                old = fracture_results_in(scratch / "earlier");

  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> moment(0.05, 0.8);
  const fs::path out = scratch / "out";
  int killed = 0;
  for (int round = 0; killed < kills && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    fs::remove_all(out);
    if (round % 2 == 1) fs::copy(scratch / "earlier", out);
    for (bool ended = false; !ended && !HasFailure();) {
      Program program(arguments_of(file, out, {"--resume", "--checkpoint-every", "0"}));
      if (killed < kills) {
        std::this_thread::sleep_for(moment(random) * whole);
        program.send(SIGKILL);
      }
      const Ended how = program.end();
      EXPECT_TRUE(how.code == 0 || how.code == 128 + SIGKILL) << how.err;
      killed += how.code != 0;
      ended = how.code == 0;
      expect_nothing_partial(out, old, fresh);
    }
    expect_same_results(fracture_results_in(out), fresh);
  }
}

TEST(ResumedFracture, WithOtherOutputsOrAnotherModelIsRefused) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::pulled_block());
  Program program(arguments_of(file, scratch / "out", {"--checkpoint-every", "0"}));
  while (program.running() && !fs::exists(scratch / "out" / test::fracture_checkpoint))
    std::this_thread::yield();
  program.send(SIGKILL);
  ASSERT_EQ(program.end().code, 128 + SIGKILL);
  const std::string kept = read_text(scratch / "out" / test::fracture_checkpoint);
  const auto refused = [&](const std::string& set) {
    const Ended ended = run_program(arguments_of(file, scratch / "out", {"--resume", "--set", set}));
    EXPECT_EQ(ended.code, 2) << set;
    EXPECT_THAT(ended.err, HasSubstr("cure: "));
    EXPECT_TRUE(read_text(scratch / "out" / test::fracture_checkpoint) == kept);
    return ended.err;
  };
  EXPECT_THAT(refused("outputs.0.name=\"other\""), HasSubstr("other [[outputs]]"));
  EXPECT_THAT(refused("bonds.0.young=2e6"), HasSubstr("belongs to another model"));
  EXPECT_THAT(refused("bonds.0.strength.seed=6"), HasSubstr("belongs to another model"));
}

TEST(ResumedFracture, IsSoughtBesideTheResultsOnly) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"fracture", scratch.write("case.toml", test::fibre_bundle()), "--resume"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--resume without --out"));
}

TEST(ResumedFracture, WithoutACheckpointStartsFromTheBeginning) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::fibre_bundle());
  const Ended ended = run_program(arguments_of(file, scratch / "out", {"--resume"}));
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("not there, starting from the beginning"));
  EXPECT_THAT(everything_in(scratch / "out"), Not(Contains(test::unfinished)));
}

}  // namespace
}  // namespace bondstatic
