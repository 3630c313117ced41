#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::everything_in;
using test::Program;
using test::ScratchFolder;
using testing::UnorderedElementsAre;

/// A held chain, quickly solved, and a large body that nothing holds: writing is most of the work.
std::string mostly_output() {
  return test::cantilever() + R"(
[[particles]]
lattice = { kind = "simple-cubic", count = [30, 30, 30], spacing = 0.2, origin = [0, 10, 0] }
radius = 0.1
[solve]
unsupported = "drop"
)";
}

/// Waits until the program writes, then sends it the signal.
Ended interrupted_while_writing(const std::string& file, const fs::path& folder, int signal) {
  Program program({"solve", file, "--out", folder.string()});
  while (program.running() && (!fs::exists(folder) || fs::is_empty(folder)))
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  program.send(signal);
  return program.end();
}

class Interrupt : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Interrupt, WhileWritingLeavesNothingBehind) {
  const auto [signal, code] = GetParam();
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", mostly_output());
  // On a busy machine the program may be through before the signal arrives: then all is there, and it counts
  // not.
  for (int attempt = 0; attempt < 10; ++attempt) {
    const Ended ended = interrupted_while_writing(file, scratch / "out", signal);
    if (ended.code == code) {
      EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("case.toml"));
      return;
    }
    ASSERT_EQ(ended.code, 0) << ended.err;
    ASSERT_TRUE(fs::exists(scratch / "out/summary.json"));
    fs::remove_all(scratch / "out");
  }
  FAIL() << "never interrupted while writing";
}

TEST_P(Interrupt, OutsideOfWritingEndsAtOnce) {
  const auto [signal, code] = GetParam();
  const ScratchFolder scratch;
  // A case that never comes: reading waits for a writer of the pipe.
  const std::string pipe = (scratch / "case.toml").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Program program({"solve", pipe, "--out", (scratch / "out").string()});
  // Opening for writing without waiting succeeds only once the program has opened it for reading.
  int writer = -1;
  while ((writer = open(pipe.c_str(), O_WRONLY | O_NONBLOCK)) < 0 && program.running())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_GE(writer, 0);
  program.send(signal);
  EXPECT_EQ(program.end().code, code);
  close(writer);
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}),
                         [](const auto& one) {
                           return std::string(one.param.first == SIGINT ? "INT" : "TERM");
                         });

}  // namespace
}  // namespace bondstatic
