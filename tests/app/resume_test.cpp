// Runs that are stopped and resumed, or killed at any moment and resumed, end with the bits of one that was
// left alone. BONDSTATIC_FULL=1 kills 200 times instead of 10.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "app/relax_cases.hpp"
#include "io/archive.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::checkpoint_name;
using test::Ended;
using test::everything_in;
using test::expect_same_results;
using test::Program;
using test::read_text;
using test::results_in;
using test::run_program;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Results = std::map<std::string, std::string>;
using Seconds = std::chrono::duration<double>;

/// Some thirty states a load case.
constexpr const char* saved_often = "dynamics.save_interval=0.5";
constexpr const char* unfinished = "relax.unfinished";

std::vector<std::string> relax_arguments(const std::string& file, const fs::path& out,
                                         const std::vector<std::string>& more = {}) {
  // One thread: where a run is planned anew, the last bits of its frequencies may depend on that.
  std::vector<std::string> arguments{"relax", file,    "--out",        out.string(), "--threads",
                                     "1",     "--set", test::long_run, "--set",      saved_often};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

class Interrupted : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Interrupted, RunKeepsACheckpointAndResumesToTheSameBits) {
  const auto [signal, code] = GetParam();
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::two_load_cases());
  ASSERT_EQ(run_program(relax_arguments(file, scratch / "whole")).code, 0);
  // While it plans a run has nothing to keep, and on a busy machine it may be through early: then the next
  // attempt waits for longer, or for less long.
  auto wait = Seconds(0.2);
  for (int attempt = 0; attempt < 20; ++attempt) {
    fs::remove_all(scratch / "out");
    Program program(relax_arguments(file, scratch / "out"));
    std::this_thread::sleep_for(wait);
    program.send(signal);
    const Ended ended = program.end();
    if (ended.code == 0) wait /= 2;
    if (ended.code == 0) continue;
    ASSERT_EQ(ended.code, code) << ended.err;
    EXPECT_THAT(ended.out, IsEmpty());
    if (!fs::exists(scratch / "out")) wait *= 1.5;
    if (!fs::exists(scratch / "out")) continue;
    auto there = everything_in(scratch / "out");
    std::erase_if(there, [](const std::string& name) { return name.starts_with(unfinished); });
    EXPECT_THAT(there, ElementsAre(checkpoint_name));
    EXPECT_THAT(ended.err, HasSubstr((scratch / "out" / checkpoint_name).string() + " keeps the run"));
    EXPECT_THAT(ended.err, HasSubstr("go on with --resume"));
    const Ended resumed = run_program(relax_arguments(file, scratch / "out", {"--resume"}));
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    expect_same_results(results_in(scratch / "out"), results_in(scratch / "whole"));
    return;
  }
  FAIL() << "never interrupted on its way";
}

TEST_P(Interrupted, RunThatKeepsNothingEndsToo) {
  const auto [signal, code] = GetParam();
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::heavy_cantilever());
  // Without damping it never comes to rest by itself.
  Program program(
      {"relax", file, "--set", "dynamics.particle_damping=0", "--set", "dynamics.time_step=1e-5"});
  std::this_thread::sleep_for(Seconds(0.3));
  program.send(signal);
  const Ended ended = program.end();
  EXPECT_EQ(ended.code, code);
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted,
                         testing::Values(std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}),
                         [](const auto& one) {
                           return std::string(one.param.first == SIGINT ? "INT" : "TERM");
                         });

bool is_staging(const std::string& name) {
  return name.starts_with(".bondstatic-");
}

/// After a kill: results are whole and all of this case or all of the one before, and checkpoints are whole;
/// what is being written lies in a staging folder and nowhere else.
void expect_nothing_partial(const fs::path& folder, const Results& old, const Results& fresh) {
  if (!fs::exists(folder)) return;
  bool all_old = true, all_fresh = true;
  for (const std::string& name : everything_in(folder)) {
    if (is_staging(name) || name.starts_with(unfinished) || fs::is_directory(folder / name)) continue;
    const std::string content = read_text(folder / name);
    if (name == checkpoint_name || name == "." + std::string(checkpoint_name) + ".new") {
      EXPECT_NO_THROW(Archive({"checkpoint", 2}, content, name)) << name;
      continue;
    }
    const std::string found =
        name == "summary.json" ? test::without_timings(nlohmann::json::parse(content)).dump() : content;
    const auto is_of = [&](const Results& results) {
      return results.contains(name) && found == results.at(name);
    };
    all_old = all_old && is_of(old);
    all_fresh = all_fresh && is_of(fresh);
    EXPECT_TRUE(all_old || all_fresh) << name << " is not of the run that the others are of";
  }
}

/// Kills at moments of its own choosing: of the whole run, of the writing of results, and of the instant in
/// which they come into place.
class Killer {
 public:
  explicit Killer(Seconds run) : run_(run) {}

  /// False where the program was through before.
  bool kill(Program& program, const fs::path& folder) {
    const int way = kills_ % 4;
    if (way < 2)
      sleep(uniform(0.6 * run_));  // what is left of a run that is resumed again and again is short
    if (way == 2) {
      while (program.running() && !writes(folder, "")) sleep(Seconds(5e-5));
      sleep(uniform(Seconds(0.01)));
    }
    if (way == 3) {
      while (program.running() && !writes(folder, "old")) std::this_thread::yield();
      sleep(uniform(Seconds(2e-4)));
    }
    program.send(SIGKILL);
    const Ended ended = program.end();
    const bool killed = ended.code == 128 + SIGKILL;
    EXPECT_TRUE(killed || ended.code == 0) << ended.err;
    kills_ += killed;
    return killed;
  }
  int kills() const { return kills_; }

 private:
  static void sleep(Seconds time) { std::this_thread::sleep_for(time); }
  Seconds uniform(Seconds most) {
    return Seconds(std::uniform_real_distribution<double>(0, most.count())(random_));
  }
  static bool writes(const fs::path& folder, const char* part) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (is_staging(entry.path().filename().string()) && fs::exists(entry.path() / part, ignored))
        return true;
    return false;
  }

  std::mt19937_64 random_{20220501};
  Seconds run_;
  int kills_ = 0;
};

TEST(Killed, AtAnyMomentResumesToTheSameBitsAndLeavesNothingPartial) {
  const int kills = test::full_run() ? 200 : 10;
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::two_load_cases());
  const std::string before = scratch.write("before.toml", test::heavy_cantilever());
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(relax_arguments(file, scratch / "whole")).code, 0);
  Killer killer(std::chrono::steady_clock::now() - begin);
  ASSERT_EQ(run_program({"relax", before, "--out", (scratch / "earlier").string()}).code, 0);
  const Results fresh = results_in(scratch / "whole"), old = results_in(scratch / "earlier");

  const fs::path out = scratch / "out";
  for (int round = 0; killer.kills() < kills && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    fs::remove_all(out);
    if (round % 2 == 1) fs::copy(scratch / "earlier", out);
    for (bool killed = true; killed && !HasFailure();) {
      Program program(relax_arguments(file, out, {"--resume", "--checkpoint-every", "0.01"}));
      if (killer.kills() < kills) {
        killed = killer.kill(program, out);
      } else {
        killed = false;
        EXPECT_EQ(program.end().code, 0);
      }
      expect_nothing_partial(out, old, fresh);
    }
    expect_same_results(results_in(out), fresh);
    EXPECT_FALSE(fs::exists(out / unfinished));
  }
}

}  // namespace
}  // namespace bondstatic
