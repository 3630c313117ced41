// What `solve` says of bonds beside beams.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Broken lines become one.
std::string unwrapped(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c != '\n' && (c != ' ' || out.empty() || out.back() != ' '))
      out += c;
    else if (out.empty() || out.back() != ' ')
      out += ' ';
  return out;
}

std::string solved(const std::string& text, const std::vector<std::string>& settings) {
  const ScratchFolder scratch;
  std::vector<std::string> arguments{"solve", scratch.write("case.toml", text)};
  for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return unwrapped(ended.out);
}

std::string with_bonds(const std::string& line) {
  std::string text = cantilever();
  const std::size_t begin = text.find("law = "), end = text.find("[[supports]]");
  return text.replace(begin, end - begin, line + "\nradius = 0.2\n");
}

TEST(ResolutionReport, SaysHowMuchARowOfBondsIsOffAndWhatIsExact) {
  EXPECT_THAT(solved(cantilever(), {"bonds.0.law=parallel", "bonds.0.radius=0.08"}),
              HasSubstr("bond law parallel: a row of 10 such bonds bends 0.258 % less than Timoshenko's beam "
                        "(one bond 23.8 % less; lambda_b 2.5); law = \"timoshenko\" is exact for any number "
                        "of bonds; kappa = 11.222222 (now 2.6) is exact for these"));
  EXPECT_THAT(solved(cantilever(), {"bonds.0.law=euler-bernoulli"}),
              HasSubstr("bond law euler-bernoulli: a row of 10 such bonds bends 0.539 % less"));
}

TEST(ResolutionReport, IsQuietWhereBondsAreBeams) {
  EXPECT_THAT(solved(cantilever(), {}), Not(HasSubstr("bond law")));
  // 0.05 %
  EXPECT_THAT(solved(cantilever(), {"bonds.0.law=euler-bernoulli", "bonds.0.radius=0.06"}),
              Not(HasSubstr("bond law")));
  EXPECT_THAT(solved(with_bonds("law = \"parallel\"\nyoung = 200e9\nkappa = 4.1111111111111111"), {}),
              Not(HasSubstr("bond law")));
}

TEST(ResolutionReport, SaysWhatItAssumes) {
  EXPECT_THAT(
      solved(with_bonds("law = \"pfc-parallel\"\neffective_modulus = 200e9\nstiffness_ratio = 2.6"), {}),
      AllOf(HasSubstr("lambda_b 1, nu = 0.25 assumed"),
            HasSubstr("law = \"timoshenko\" with young = 2e+11 (kn L/A) and a poisson is exact"),
            HasSubstr("stiffness_ratio = 4.1111111 (now 2.6)")));
}

TEST(ResolutionReport, CallsADifferenceInAPackingADifference) {
  const std::string lattice = R"([[particles]]
lattice = { kind = "simple-cubic", count = [3, 3, 3], spacing = 1 }
radius = 0.5
[[bonds]]
law = "parallel"
gap = 0
young = 1e9
poisson = 0.2
[[supports]]
at = { lowest = { axis = "z", within = 0 } }
fix = "all"
[[loads]]
at = { highest = { axis = "z", within = 0 } }
force = [1, 0, 0]
)";
  EXPECT_THAT(
      solved(lattice, {}),
      AllOf(HasSubstr("bond law parallel: ks 1.67 times a Timoshenko bond's (lambda_b 1), kn and kb the "
                      "same; a difference of bond laws, no error of a packing"),
            Not(HasSubstr("exact"))));
}

TEST(ResolutionReport, StandsInFullInTheSummary) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever()), out = (scratch / "out").string();
  const Ended ended = run_program({"solve", file, "--json", "--out", out, "--set", "bonds.0.law=parallel"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto blocks = nlohmann::json::parse(ended.out)["resolution"];
  EXPECT_EQ(blocks, nlohmann::json::parse(read_text(scratch / "out/summary.json"))["resolution"]);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0]["law"], "parallel");
  EXPECT_EQ(blocks[0]["bonds_in_rows"], 10);
  EXPECT_NEAR(blocks[0]["deflection_error"]["median"].get<double>(), -0.00303, 5e-6);
  EXPECT_NEAR(blocks[0]["beam_kappa"]["median"].get<double>(), 4.0 / 3 + 20 * 1.3 / 9, 1e-14);
  EXPECT_EQ(blocks[0]["bonds_for_one_percent"]["median"], 6);
  EXPECT_EQ(blocks[0]["advice"].size(), 4u);
  EXPECT_FALSE(nlohmann::json::parse(run_program({"solve", file, "--json"}).out).contains("resolution"));
}

}  // namespace
}  // namespace bondstatic::test
