#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_program.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {
namespace {

using test::Ended;
using test::run_program;
using testing::HasSubstr;
using testing::IsEmpty;

struct Misuse {
  const char* what;
  std::vector<std::string> arguments;
  std::string said;
};

std::ostream& operator<<(std::ostream& stream, const Misuse& misuse) {
  return stream << misuse.what;
}

class CommandLineMisuse : public testing::TestWithParam<Misuse> {};

TEST_P(CommandLineMisuse, Ends2AndSaysHow) {
  const Ended ended = run_program(GetParam().arguments);
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(GetParam().said));
  EXPECT_THAT(ended.out, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, CommandLineMisuse,
    testing::Values(
        Misuse{"NoCommand",
               {},
               "a command is missing: solve, sweep, relax, fracture, check, calibrate, report, import,"},
        Misuse{"MisspeltCommand", {"slove", "case.toml"}, "did you mean \"solve\"?"},
        Misuse{"UnknownCommand", {"frobnicate"}, "unknown command \"frobnicate\""},
        Misuse{"EmptyCommand", {""}, "unknown command \"\""},
        Misuse{"MisspeltOption", {"solve", "case.toml", "--thread=3"}, "did you mean \"--threads\"?"},
        Misuse{"MisspeltOptionWithValue", {"solve", "case.toml", "--slover", "eigen"}, "--solver"},
        Misuse{"MisspeltGlobalOption", {"--versoin"}, "did you mean \"--version\"?"},
        Misuse{"UnknownOption", {"laws", "--frobnicate"}, "unknown option --frobnicate"},
        Misuse{"NoCase", {"solve"}, "CASE is required"},
        Misuse{"TwoCases", {"solve", "a.toml", "b.toml"}, "unexpected argument \"b.toml\""},
        Misuse{"ZeroThreads", {"solve", "a.toml", "--threads", "0"}, "threads"},
        Misuse{"OptionWithoutValue", {"solve", "a.toml", "--out"}, "--out"},
        Misuse{"MissingFile", {"solve", "no/such/case.toml"}, "no/such/case.toml"},
        Misuse{"MisspeltLaw", {"laws", "timoshenk"}, "did you mean \"timoshenko\"?"},
        Misuse{"MisspeltRelax", {"relx", "case.toml"}, "did you mean \"relax\"?"},
        Misuse{"MisspeltCheck", {"chekc", "case.toml"}, "did you mean \"check\"?"},
        Misuse{"RelaxWithoutCase", {"relax"}, "CASE is required"},
        Misuse{"CheckWithoutCase", {"check", "--json"}, "CASE is required"},
        Misuse{"CheckpointsTooOften", {"relax", "a.toml", "--checkpoint-every", "-1"}, "--checkpoint-every"},
        Misuse{
            "CheckpointsNoNumber", {"relax", "a.toml", "--checkpoint-every", "often"}, "--checkpoint-every"},
        Misuse{"MisspeltResume", {"relax", "a.toml", "--resum"}, "did you mean \"--resume\"?"},
        Misuse{"NothingToResume", {"check", "a.toml", "--resume"}, "unknown option --resume"},
        Misuse{"SolveDoesNotResume", {"solve", "a.toml", "--resume"}, "unknown option --resume"},
        Misuse{"NothingVaried", {"sweep", "a.toml"}, "--vary is required"},
        Misuse{"VaryWithoutValues", {"sweep", "a.toml", "--vary", "bonds.0.young"}, "KEY=v1,v2"},
        Misuse{"VaryWithEmptyValue", {"sweep", "a.toml", "--vary", "k=1,,2"}, "empty value"},
        Misuse{"ZipOfUnequalLength", {"sweep", "a.toml", "--vary", "k:l=1:2,3"}, "2 keys"},
        Misuse{"VariedTwice", {"sweep", "a.toml", "--vary", "k=1", "--vary", "k=2"}, "varied twice"}),
    [](const auto& one) { return std::string(one.param.what); });

TEST(CommandLine, HelpAndVersionEnd0) {
  EXPECT_THAT(run_program({"--help"}).out, HasSubstr("sweep"));
  EXPECT_THAT(run_program({"solve", "--help"}).out, HasSubstr("--set"));
  for (const char* option : {"--resume", "--checkpoint-every", "--out", "--json", "--threads"})
    EXPECT_THAT(run_program({"relax", "--help"}).out, HasSubstr(option));
  EXPECT_THAT(run_program({"check", "--help"}).out, HasSubstr("certificate"));
  const Ended version_told = run_program({"--version"});
  EXPECT_EQ(version_told.code, 0);
  EXPECT_THAT(version_told.out, HasSubstr("bondstatic " + version()));
  EXPECT_THAT(version_told.out, HasSubstr("BLAS: "));
  EXPECT_THAT(version_told.out, HasSubstr(available_solvers().front().name));
}

TEST(CommandLine, LawsListsEveryLawWithItsParametersAndSource) {
  const Ended text = run_program({"laws"});
  const auto json = nlohmann::json::parse(run_program({"laws", "--json"}).out);
  EXPECT_EQ(text.code, 0);
  ASSERT_EQ(json.size(), bond_laws().size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const BondLaw& law = bond_laws()[i];
    EXPECT_THAT(text.out, HasSubstr(law.name + "  " + law.title));
    for (const std::string& formula : law.formulas) EXPECT_THAT(text.out, HasSubstr(formula));
    EXPECT_EQ(json[i]["name"], law.name);
    EXPECT_EQ(json[i]["source"], law.source);
    ASSERT_EQ(json[i]["parameters"].size(), law.parameters.size());
    for (std::size_t p = 0; p < law.parameters.size(); ++p) {
      EXPECT_EQ(json[i]["parameters"][p]["name"], law.parameters[p].name);
      EXPECT_EQ(json[i]["parameters"][p]["unit"], si_unit(law.parameters[p].dimension));
      EXPECT_THAT(text.out, HasSubstr(law.parameters[p].meaning));
    }
  }
}

TEST(CommandLine, OneLawCanBeAskedFor) {
  const auto json = nlohmann::json::parse(run_program({"laws", "timoshenko", "--json"}).out);
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["name"], "timoshenko");
}

TEST(CommandLine, SolversAreThoseOfTheBuild) {
  const auto json = nlohmann::json::parse(run_program({"solvers", "--json"}).out);
  ASSERT_EQ(json.size(), available_solvers().size());
  EXPECT_EQ(json[0]["name"], available_solvers()[0].name);
}

}  // namespace
}  // namespace bondstatic
