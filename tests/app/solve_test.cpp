#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::cantilever;
using test::Ended;
using test::everything_in;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

TEST(Solve, PrintsTheAnswerBesideWhatIsExpected) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"solve", scratch.write("case.toml", cantilever())});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* part : {"cantilever", "11 particles, 10 bonds (timoshenko)", "tip", "-8.534241726",
                           "[Chen2022] Eq. 29", "relative error at most", "memory"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  EXPECT_THAT(ended.out, Not(HasSubstr("\033")));
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("case.toml"));
}

TEST(Solve, JsonIsTheSummaryAndNothingElse) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended = run_program({"solve", file, "--json", "--out", (scratch / "out").string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto summary = nlohmann::json::parse(ended.out);
  EXPECT_EQ(summary, nlohmann::json::parse(read_text(scratch / "out/summary.json")));
  EXPECT_LT(summary["outputs"][0]["relative_error"].get<double>(), 1e-13);
  EXPECT_EQ(summary["files"].size(), everything_in(scratch / "out").size());
}

TEST(Solve, ResolvedCaseGivesTheSameAnswer) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  ASSERT_EQ(
      run_program({"solve", file, "--set", "bonds.0.young=70e9", "--out", (scratch / "a").string()}).code, 0);
  const Ended again =
      run_program({"solve", (scratch / "a/case.resolved.toml").string(), "--out", (scratch / "b").string()});
  ASSERT_EQ(again.code, 0) << again.err;
  for (const char* name : {"particles.csv", "bonds.csv", "model.vtu"})
    EXPECT_EQ(read_text(scratch / "a" / name), read_text(scratch / "b" / name)) << name;
}

TEST(Solve, EverySetIsAppliedAndNeitherSwallowsTheCase) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const Ended ended = run_program(
      {"solve", "--set", "outputs.0.scale=2e3", "--set", "loads.0.force=[0, -50e3, 0]", file, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_LT(nlohmann::json::parse(ended.out)["outputs"][0]["relative_error"].get<double>(), 1e-13);
}

TEST(Solve, ThreadsAndSolverAreTakenFromTheCommandLine) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const auto summary = nlohmann::json::parse(
      run_program({"solve", file, "--json", "--solver", "eigen", "--threads", "2"}).out);
  EXPECT_EQ(summary["solver"]["name"], "eigen");
  EXPECT_EQ(summary["solver"]["threads_asked"], 2);
  EXPECT_LE(summary["solver"]["threads"], 2);
}

struct Failure {
  const char* what;
  std::vector<std::string> arguments;
  int code;
  std::string said;
};

std::ostream& operator<<(std::ostream& stream, const Failure& failure) {
  return stream << failure.what;
}

class SolveFailure : public testing::TestWithParam<Failure> {};

TEST_P(SolveFailure, EndsWithItsCodeSaysWhyAndWritesNothing) {
  const ScratchFolder scratch;
  std::vector<std::string> arguments{"solve", scratch.write("case.toml", cantilever()), "--out",
                                     (scratch / "new/out").string()};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, GetParam().code);
  EXPECT_THAT(ended.err, HasSubstr(GetParam().said));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(
    All, SolveFailure,
    testing::Values(Failure{"InvalidInput", {"--set", "bonds.0.young=-5"}, 2, "young"},
                    Failure{"UnknownSolver", {"--solver", "magic"}, 2, "magic"},
                    Failure{"Mechanism", {"--set", "supports.0.fix=[\"x\"]"}, 3, "free to"},
                    Failure{"MemoryLimit", {"--set", "solve.memory_limit=1000"}, 5, "memory"}),
    [](const auto& one) { return std::string(one.param.what); });

TEST(Solve, FailureLeavesEarlierResultsAlone) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever()), out = (scratch / "out").string();
  ASSERT_EQ(run_program({"solve", file, "--out", out}).code, 0);
  const std::string before = read_text(scratch / "out/summary.json");
  EXPECT_EQ(run_program({"solve", file, "--out", out, "--set", "supports.0.fix=[\"x\"]"}).code, 3);
  EXPECT_EQ(read_text(scratch / "out/summary.json"), before);
}

TEST(Solve, RunAgainWithOtherLoadCasesLeavesNoStaleFiles) {
  const ScratchFolder scratch;
  const std::string out = (scratch / "out").string();
  std::string two = cantilever() + "case = \"down\"\n";
  two.replace(two.find("force = "), 0, "case = \"down\"\n");
  two += "[[loads]]\nat = { id = 11 }\nmoment = [1, 0, 0]\ncase = \"twist\"\n";
  const Ended ended = run_program({"solve", scratch.write("two.toml", two), "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(scratch / "out/twist/particles.csv"));
  ASSERT_EQ(run_program({"solve", scratch.write("one.toml", cantilever()), "--out", out}).code, 0);
  EXPECT_THAT(everything_in(out), UnorderedElementsAre("summary.json", "particles.csv", "bonds.csv",
                                                       "model.vtu", "case.resolved.toml"));
}

TEST(Solve, UnwritableFolderIsNamedBeforeTheSolve) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const std::string out = (scratch / "case.toml/out").string();
  // Were it solved first, the mechanism would be found first.
  const Ended ended = run_program({"solve", file, "--out", out, "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(out));
}

TEST(Solve, InputFilesOfTheUserAreNotOverwritten) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  scratch.write("particles.csv", "mine");
  EXPECT_EQ(run_program({"solve", file, "--out", scratch.path().string()}).code, 2);
  EXPECT_EQ(read_text(scratch / "particles.csv"), "mine");
}

TEST(Solve, AnswerThatCannotBePrintedIsAnError) {
  const ScratchFolder scratch;
  const std::string command = std::string(BONDSTATIC_PROGRAM) + " solve " +
                              scratch.write("case.toml", cantilever()) + " > /dev/full 2> " +
                              (scratch / "err").string();
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_THAT(read_text(scratch / "err"), HasSubstr("standard output"));
}

}  // namespace
}  // namespace bondstatic
