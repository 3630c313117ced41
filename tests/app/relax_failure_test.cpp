// What relax says where it cannot give an answer, and that it then writes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/relax_cases.hpp"

namespace bondstatic {
namespace {

using test::Ended;
using test::everything_in;
using test::heavy_cantilever;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

struct Failure {
  const char* what;
  std::vector<std::string> set;
  int code;
  std::vector<std::string> said;
};

std::ostream& operator<<(std::ostream& stream, const Failure& failure) {
  return stream << failure.what;
}

class RelaxFailure : public testing::TestWithParam<Failure> {};

TEST_P(RelaxFailure, EndsWithItsCodeSaysWhyAndWritesNothing) {
  const ScratchFolder scratch;
  std::vector<std::string> arguments{"relax", scratch.write("case.toml", heavy_cantilever()), "--out",
                                     (scratch / "new/out").string()};
  for (const std::string& set : GetParam().set) arguments.insert(arguments.end(), {"--set", set});
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, GetParam().code);
  for (const std::string& part : GetParam().said) EXPECT_THAT(ended.err, HasSubstr(part));
  EXPECT_THAT(ended.err, HasSubstr("cure: "));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(
    All, RelaxFailure,
    testing::Values(
        Failure{"TimeStepTooLarge",
                {"dynamics.time_step=1e-3"},
                4,
                {"blew up", "19.9", "times the critical one", "leave time_step out"}},
        Failure{"Mechanism", {"supports.0.fix=[\"x\"]"}, 3, {"free to"}},
        Failure{"UnknownKey",
                {"dynamics.kinematic=small"},
                2,
                {"--set dynamics.kinematic=small", "did you mean \"kinematics\"?"}},
        Failure{"UnknownKinematics", {"dynamics.kinematics=smal"}, 2, {"smal", "\"small\""}},
        Failure{"DampingOfOne", {"dynamics.particle_damping=1"}, 2, {"particle_damping = 1 must be below 1"}},
        Failure{"NegativeBondDamping", {"dynamics.bond_damping=-0.1"}, 2, {"bond_damping"}},
        Failure{
            "StepAndSafety", {"dynamics.time_step=1e-5", "dynamics.safety=0.5"}, 2, {"time_step", "safety"}},
        Failure{"NoSteps", {"dynamics.max_steps=0"}, 2, {"max_steps"}},
        Failure{"UnknownCheckKey", {"check.tolerence=1e-3"}, 2, {"did you mean \"tolerance\"?"}},
        Failure{"NoDensity", {"particles.0.density=0"}, 2, {"density"}}),
    [](const auto& one) { return std::string(one.param.what); });

TEST(Relax, CaseWithoutDensityIsTurnedDownWithThePlaceAndACure) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::cantilever());
  const Ended ended = run_program({"relax", file, "--out", (scratch / "out").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, StartsWith(file + ":2:1: particles without density"));
  EXPECT_THAT(ended.err, HasSubstr("cure: add density"));
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST(Relax, WrongDynamicsAreToldTogetherWithTheirPlaces) {
  const ScratchFolder scratch;
  const std::string file =
      scratch.write("case.toml", heavy_cantilever() +
                                     "[dynamics]\nramp = \"sudden\"\n  hold_time = -1.0\nvelocity = 1e-9\n");
  const Ended ended = run_program({"relax", file});
  EXPECT_EQ(ended.code, 2);
  const auto line = [&](const std::string& key) {
    const std::string text = read_text(file);
    return std::to_string(1 + std::count(text.begin(), text.begin() + long(text.find("\n" + key) + 1), '\n'));
  };
  EXPECT_THAT(ended.err, HasSubstr(file + ":" + line("ramp = ") + ":"));
  EXPECT_THAT(ended.err, HasSubstr(file + ":" + line("  hold_time") + ":"));
  EXPECT_THAT(ended.err,
              HasSubstr(file + ":" + line("velocity") + ":1: unknown key \"velocity\" in [dynamics]"));
}

TEST(Relax, UnwritableFolderIsNamedBeforeTheRun) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", heavy_cantilever());
  const std::string out = (scratch / "case.toml/out").string();
  // Were it planned first, the mechanism would be found first.
  const Ended ended = run_program({"relax", file, "--out", out, "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(out));
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST(Relax, FilesOfTheUserAreNotOverwritten) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", heavy_cantilever());
  scratch.write("history.csv", "mine");
  const Ended ended =
      run_program({"relax", file, "--out", scratch.path().string(), "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("history.csv: exists and is not a result"));
  EXPECT_EQ(read_text(scratch / "history.csv"), "mine");
}

TEST(Relax, FailureLeavesEarlierResultsAlone) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", heavy_cantilever()), out = (scratch / "out").string();
  ASSERT_EQ(run_program({"relax", file, "--out", out}).code, 0);
  const auto before = test::results_in(out);
  EXPECT_EQ(run_program({"relax", file, "--out", out, "--set", "dynamics.time_step=1e-3"}).code, 4);
  EXPECT_EQ(run_program({"relax", file, "--out", out, "--set", "supports.0.fix=[\"x\"]"}).code, 3);
  test::expect_same_results(test::results_in(out), before);
}

}  // namespace
}  // namespace bondstatic
