// `calibrate` as a user runs it, on the cases of cases/calibration.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string cases = BONDSTATIC_SOURCE_DIR "/cases/calibration/";

json answer(std::vector<std::string> arguments, int code = 0) {
  arguments.insert(arguments.begin(), "calibrate");
  arguments.push_back("--json");
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, code) << ended.err;
  return json::parse(ended.out);
}

double value(const json& answer, std::size_t parameter) {
  return answer.at("parameters").at(parameter).at("value");
}

double achieved(const json& answer, std::size_t target) {
  return answer.at("targets").at(target).at("achieved");
}

void expect_near(double found, double expected, double relative) {
  EXPECT_NEAR(found, expected, relative * std::abs(expected));
}

// kappa = 4/3 lambda^2 + 20/9 (1 + nu), lambda = L_bond / 2r = 10 / n here, nu = 0.3, for any number n of
// bonds: n bonds of parallel law bend F L^3 / 3EI + F L^3 / EI (kappa r^2 / 4 - L_bond^2 / 12) / L^2.
TEST(Calibrate, FindsTheRatioThatGivesTimoshenkosDeflection) {
  for (const int bonds : {1, 2, 3, 7, 10, 40}) {
    const json found = answer({cases + "cantilever-kappa.toml", "--set",
                               "particles.0.line.count=" + std::to_string(bonds + 1), "--set",
                               "particles.0.radius=" + std::to_string(2.02 / bonds)});
    const double lambda = 10.0 / bonds;
    expect_near(value(found, 0), 4 * lambda * lambda / 3 + 20 * 1.3 / 9, 1e-9);
    expect_near(achieved(found, 0), 8.5342417262387432, 1e-12);
  }
}

TEST(Calibrate, ThePackingReachesItsModulusAndPoissonsRatio) {
  const json found = answer({cases + "yade.toml"});
  EXPECT_EQ(found.at("converged"), true);
  EXPECT_EQ(found.at("reached"), true);
  EXPECT_LT(found.at("solves").get<int>(), 10);
  EXPECT_EQ(found.at("history").size(), found.at("solves").get<std::size_t>());
  expect_near(achieved(found, 0), 35e9, 1e-9);
  expect_near(achieved(found, 1), 0.20, 1e-9);
  for (const json& parameter : found.at("parameters")) {
    EXPECT_LT(parameter.at("lower_95").get<double>(), parameter.at("value").get<double>());
    EXPECT_GT(parameter.at("upper_95").get<double>(), parameter.at("value").get<double>());
  }
}

// Beam bonds tie shear to bending: the packing's ratio stays below 0.25 whatever the material's.
TEST(Calibrate, SaysWhatIsOutOfReachAndWhatCanBeHad) {
  const ScratchFolder folder;
  const Ended ended = run_program({"calibrate", cases + "yade.toml", "--set",
                                   "calibration.targets.1.wanted=0.30", "--out", folder.path().string()});
  EXPECT_EQ(ended.code, int(ExitCode::not_accurate)) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("targets not reached"), HasSubstr("out of reach"),
                               HasSubstr("0.5, which holds it")));
  const json found = json::parse(read_text(folder / "calibration.json"));
  EXPECT_EQ(found.at("converged"), true);
  EXPECT_EQ(found.at("reached"), false);
  EXPECT_EQ(found.at("parameters").at(1).at("at_bound"), true);
  EXPECT_EQ(value(found, 1), 0.5);
  EXPECT_GT(achieved(found, 1), 0.23);
  EXPECT_LT(achieved(found, 1), 0.25);
}

TEST(Calibrate, ParallelBondsReachWhatBeamBondsDoNot) {
  const json found = answer({cases + "yade-parallel.toml"});
  EXPECT_LT(found.at("solves").get<int>(), 10);
  expect_near(achieved(found, 0), 35e9, 1e-9);
  expect_near(achieved(found, 1), 0.30, 1e-9);
}

// Bending of an Euler-Bernoulli beam knows E I = E pi r^4 / 4 alone.
TEST(Calibrate, SaysWhatTheTestsCannotTellApart) {
  const std::string file = cases + "unidentifiable.toml";
  const json found = answer({file});
  ASSERT_EQ(found.at("unidentified").size(), 1u);
  const json& direction = found.at("unidentified").at(0).at("direction");
  const double young = direction.at("bonds.0.young"), radius = direction.at("bonds.0.radius_factor");
  expect_near(young / radius, -4, 1e-6);
  for (const json& parameter : found.at("parameters")) EXPECT_TRUE(parameter.at("lower_95").is_null());
  const double factor = value(found, 1);
  // F L^3 / 3 E I of r = 0.2 and E = 200 GPa is 8.488264 mm; the targets were rounded: least squares of both
  const double product = value(found, 0) * std::pow(factor, 4);
  const double rounded = (8.488 + 2 * 16.977) / 5;
  expect_near(product, 200e9 * 8.4882636315677518 / rounded, 1e-9);
  EXPECT_THAT(run_program({"calibrate", file}).out,
              HasSubstr("act only through bonds.0.young\n                   bonds.0.radius_factor^4"));
}

TEST(Calibrate, SeedsAreTestsOfTheirOwn) {
  const json found = answer({cases + "edem-seeds.toml", "--set", "calibration.seeds.values=[1, 3]"});
  EXPECT_EQ(found.at("tests").size(), 2u);
  EXPECT_EQ(found.at("targets").size(), 4u);
  EXPECT_EQ(found.at("solves").get<std::size_t>(), 2 * found.at("history").size());
  const json& scatter = found.at("scatter").at(0);
  EXPECT_EQ(scatter.at("output"), "E");
  const double one = achieved(found, 0), two = achieved(found, 1);
  expect_near(scatter.at("mean"), (one + two) / 2, 1e-15);
  expect_near(scatter.at("standard_deviation"), std::abs(one - two) / std::sqrt(2), 1e-6);
  EXPECT_THAT(found.at("tests").at(1).at("name"), "edem-seeds.toml, particles.0.seed=3");
}

TEST(Calibrate, WritesACaseThatSolvesToWhatWasAchieved) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  const std::string file = cases + "edem-seeds.toml";
  const json found =
      answer({file, "--out", out, "--set", "particles.0.seed=3", "--set", "calibration.seeds.values=[3]"});
  EXPECT_THAT(everything_in(out), ElementsAre("calibrated.toml", "calibration.json", "history.csv"));
  EXPECT_EQ(json::parse(read_text(out + "/calibration.json")), found);
  const Ended solved = run_program({"solve", out + "/calibrated.toml", "--json"});
  ASSERT_EQ(solved.code, 0) << solved.err;
  const json outputs = json::parse(solved.out).at("outputs");
  for (std::size_t i = 0; i < 2; ++i) expect_near(outputs.at(i).at("value"), achieved(found, i), 1e-15);
  // From there nothing is left to do.
  const json again = answer({out + "/calibrated.toml"});
  EXPECT_LE(again.at("history").size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) expect_near(value(again, i), value(found, i), 1e-9);
}

TEST(Calibrate, HistoryHasARowAnEvaluation) {
  const ScratchFolder folder;
  const json found = answer({cases + "cantilever-kappa.toml", "--out", folder.path().string()});
  const std::string history = read_text(folder / "history.csv");
  EXPECT_THAT(history, testing::StartsWith("evaluation,cost,seconds,accepted,kappa\n1,"));
  EXPECT_EQ(std::size_t(std::count(history.begin(), history.end(), '\n')), found.at("history").size() + 1);
}

TEST(Calibrate, TellsOfBestWhereItWasStopped) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  const json found =
      answer({cases + "cantilever-kappa.toml", "--out", out, "--set", "calibration.most_evaluations=2"},
             int(ExitCode::not_accurate));
  EXPECT_EQ(found.at("converged"), false);
  EXPECT_THAT(found.at("reason").get<std::string>(), HasSubstr("2 evaluations"));
  EXPECT_EQ(everything_in(out).size(), 3u);
}

/// The reference cantilever with its tip to be met by young.
std::string cantilever_with(const std::string& calibration) {
  return cantilever() + "[calibration]\n" + calibration + R"(
[[calibration.parameters]]
key = "young"
min = "1 GPa"
max = "1000 GPa"
start = "70 GPa"
[[calibration.targets]]
output = "tip"
wanted = "-8.5342417262387432 mm"
)";
}

TEST(Calibrate, TakesOutputsOfSeveralCases) {
  const ScratchFolder folder;
  folder.write("other.toml", cantilever());
  const json found = answer({folder.write("case.toml", cantilever_with("cases = [\"other.toml\"]"))});
  EXPECT_EQ(found.at("targets").size(), 2u);
  expect_near(value(found, 0), 200e9, 1e-12);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(achieved(found, i), -8.5342417262387432, 1e-14);
  // Student's t of one degree of freedom: both residuals are nothing but rounding.
  const json& young = found.at("parameters").at(0);
  expect_near(young.at("lower_95"), 200e9, 1e-10);
}

TEST(Calibrate, AllSolversFindTheSame) {
  const ScratchFolder folder;
  const std::string file = folder.write("case.toml", cantilever_with(""));
  for (const char* solver : {"eigen", "multigrid"})
    expect_near(value(answer({file, "--solver", solver, "--threads", "2"}), 0), 200e9, 1e-12);
}

TEST(Calibrate, InvalidInputEndsWith2AndLeavesNothing) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  const std::string plain = folder.write("plain.toml", cantilever());
  const std::string file = folder.write("case.toml", cantilever_with(""));
  const std::string blocked = folder.write("blocked", "a file, not a folder");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"calibrate", plain, "--out", out},
        {"calibrate", file, "--out", out, "--set", "calibration.targets.0.output=top"},
        {"calibrate", file, "--out", blocked},
        {"calibrate", file, "--out", out, "--solver", "cholmud"}}) {
    const Ended ended = run_program(arguments);
    EXPECT_EQ(ended.code, int(ExitCode::invalid_input)) << arguments[1];
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, HasSubstr("cure: "));
  }
  EXPECT_THAT(everything_in(folder.path()), ElementsAre("blocked", "case.toml", "plain.toml"));
}

TEST(Calibrate, ReplacesOnlyWhatACalibrationLeft) {
  const ScratchFolder folder;
  const std::string out = folder.path().string();
  const std::string mine = folder.write("history.csv", "mine");
  const Ended refused = run_program({"calibrate", cases + "cantilever-kappa.toml", "--out", out});
  EXPECT_EQ(refused.code, int(ExitCode::invalid_input));
  EXPECT_THAT(refused.err, HasSubstr("history.csv"));
  EXPECT_EQ(read_text(mine), "mine");
  EXPECT_THAT(everything_in(out), ElementsAre("history.csv"));

  std::filesystem::remove(mine);
  for (int time = 0; time < 2; ++time) answer({cases + "cantilever-kappa.toml", "--out", out});
  const std::string calibrated = read_text(folder / "calibrated.toml");
  const Ended onto_itself = run_program({"calibrate", out + "/calibrated.toml", "--out", out});
  EXPECT_EQ(onto_itself.code, int(ExitCode::invalid_input));
  EXPECT_EQ(read_text(folder / "calibrated.toml"), calibrated);
}

TEST(Calibrate, IsNothingToSolve) {
  const ScratchFolder folder;
  const Ended ended = run_program({"solve", folder.write("case.toml", cantilever_with(""))});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, Not(HasSubstr("warning")));
}

}  // namespace
}  // namespace bondstatic::test
