// The program beside a real run by LAMMPS: cases/lammps-bpm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {

namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const std::string folder = std::string(BONDSTATIC_SOURCE_DIR) + "/cases/lammps-bpm/";

Ended compare_lammps(std::vector<std::string> more) {
  std::vector<std::string> arguments{
      "compare", folder + "case.toml", folder + "dump.final", "--threads", "1", "--solver", "cholmod"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

Json field(const Json& comparison, const std::string& name) {
  for (const Json& one : comparison["fields"])
    if (one["field"] == name) return one;
  return {};
}

TEST(CompareCommand, LammpsRunIsTheSameState) {
  const ScratchFolder out;
  const Ended ended =
      compare_lammps({"--json", "--out", (out / "results").string(), "--bonds", folder + "dump.bonds",
                      "--bond-columns", "c_bl[1],c_bl[2]", "--bond-force", "c_bf[2],c_bf[3],c_bf[4]"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json comparison = Json::parse(ended.out)["comparison"];
  EXPECT_EQ(comparison["verdict"], "same state");
  const Json displacement = field(comparison, "displacement");
  EXPECT_NEAR(displacement["difference"].get<double>(), 1.2e-4, 0.05e-4);
  EXPECT_NEAR(displacement["best_fit_scale"].get<double>(), 1.000117, 1e-6);
  EXPECT_NEAR(field(comparison, "rotation")["difference"].get<double>(), 1.4e-4, 0.05e-4);
  EXPECT_NEAR(field(comparison, "normal force")["difference"].get<double>(), 9.4e-5, 0.5e-5);
  EXPECT_NEAR(field(comparison, "normal force")["best_fit_scale"].get<double>(), 1, 1e-4);
  // Second order of the run's rotations is most of what its state carries.
  const Json state = comparison["state"];
  EXPECT_LT(state["residual_finite"].get<double>(), 0.2 * state["residual_linear"].get<double>());
  EXPECT_EQ(everything_in(out.path()),
            (std::set<std::string>{"results", "results/bonds.csv", "results/case.resolved.toml",
                                   "results/model.vtu", "results/particles.csv", "results/summary.json"}));
  EXPECT_EQ(read_text(out / "results/summary.json"), ended.out);
  EXPECT_THAT(read_text(out / "results/particles.csv"), HasSubstr("rz,run_ux,run_uy,run_uz,run_rx"));
  EXPECT_THAT(read_text(out / "results/bonds.csv"), HasSubstr("difference_fx"));
  for (const char* name : {"\"run_displacement\"", "\"displacement_difference\"", "\"difference_fx\""})
    EXPECT_THAT(read_text(out / "results/model.vtu"), HasSubstr(name));
}

/// Verdict "different model" with exit 4; gives the comparison.
Json another_model(const std::vector<std::string>& overrides) {
  std::vector<std::string> more{"--json"};
  for (const std::string& one : overrides) more.insert(more.end(), {"--set", one});
  const Ended ended = compare_lammps(more);
  EXPECT_EQ(ended.code, 4) << ended.err;
  const Json comparison = Json::parse(ended.out)["comparison"];
  EXPECT_EQ(comparison["verdict"], "different model") << comparison["reason"];
  return comparison;
}

TEST(CompareCommand, LammpsRunTellsAWrongShearStiffness) {
  const Json comparison = another_model({"bonds.0.ks=4.04e5"});
  EXPECT_THAT(comparison["reason"].get<std::string>(), HasSubstr("shear stiffness 0.990"));
  EXPECT_NEAR(field(comparison, "displacement")["difference"].get<double>(), 3.5e-3, 0.05e-3);
  EXPECT_NEAR(field(comparison, "displacement")["best_fit_scale"].get<double>(), 1.0035, 1e-4);
}

TEST(CompareCommand, LammpsRunTellsAWrongNormalStiffness) {
  EXPECT_THAT(another_model({"bonds.0.kn=1.1e6"})["reason"].get<std::string>(),
              HasSubstr("normal stiffness 0.909"));
}

TEST(CompareCommand, LammpsRunTellsAnotherContactPoint) {
  EXPECT_THAT(another_model({"bonds.0.contact_point=gap"})["reason"].get<std::string>(),
              HasSubstr("contact point at mid-length"));
}

TEST(CompareCommand, LammpsRunTellsOtherLoads) {
  EXPECT_THAT(another_model({"loads.0.force=[0.00204, 0, -0.0102]"})["reason"].get<std::string>(),
              HasSubstr("all loads 0.980"));
}

/// The cantilever's particles, moved by so much of its static answer; a step each.
std::string cantilever_dump(const std::vector<double>& parts) {
  // Euler-Bernoulli with shear, as the case's bonds: exact at the particles.
  const double force = -100e3, length = 4, young = 200e9, poisson = 0.3, r = 0.2;
  const double area = M_PI * r * r, inertia = M_PI * r * r * r * r / 4, shear = young / 2 / (1 + poisson);
  std::string text;
  for (std::size_t step = 0; step < parts.size(); ++step) {
    text += "ITEM: TIMESTEP\n" + std::to_string(100 * step) +
            "\nITEM: NUMBER OF ATOMS\n11\nITEM: BOX BOUNDS ff ff ff\n-1 9\n-1 9\n-1 9\n"
            "ITEM: ATOMS id x y z quatw quati quatj quatk\n";
    for (int p = 0; p < 11; ++p) {
      const double x = 0.4 * p;
      const double y = force * (x * x * (3 * length - x) / (6 * young * inertia) + x / (0.9 * shear * area));
      const double turn = force * x * (2 * length - x) / (2 * young * inertia);
      char line[200];
      std::snprintf(line, sizeof line, "%d %.17g %.17g 0 %.17g 0 0 %.17g\n", p + 1, x, parts[step] * y,
                    std::cos(parts[step] * turn / 2), std::sin(parts[step] * turn / 2));
      text += line;
    }
  }
  return text;
}

TEST(CompareCommand, ASeriesIsATableOfSteps) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const std::string dump = scratch.write("dump", cantilever_dump({0.5, 0.9, 1}));
  const Ended ended =
      run_program({"compare", file, dump, "--every-step", "--out", (scratch / "out").string()});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("same state: displacements differ by"));
  const std::string table = read_text(scratch / "out/steps.csv");
  EXPECT_THAT(table, testing::StartsWith("step,displacement,rotation,scale,energy,kinetic,residual\n0,0."));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  // Of one step: as it is.
  const Ended half = run_program({"compare", file, dump, "--step", "0"});
  EXPECT_EQ(half.code, 4);
  EXPECT_THAT(half.out, HasSubstr("all loads 0.5"));
}

TEST(CompareCommand, BondForcesOfTheLastStepLeaveTheColumnsOfASeriesInPlace) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  ASSERT_EQ(run_program({"solve", file, "--out", (scratch / "solved").string()}).code, 0);
  const Ended ended = run_program({"compare", file, scratch.write("dump", cantilever_dump({0.5, 1})),
                                   "--every-step", "--bonds", (scratch / "solved/bonds.csv").string()});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const std::size_t head = ended.out.find("  step"), first = ended.out.find('\n', head) + 1;
  const std::size_t energy = ended.out.find("energy", head) - head;
  ASSERT_LT(energy, first - head) << ended.out;
  // A quarter of the energy.
  EXPECT_EQ(ended.out.substr(first + energy - 1, 7), "7.5e-01") << ended.out;
}

TEST(CompareCommand, SeveralLoadCasesNeedAName) {
  const ScratchFolder scratch;
  std::string text = cantilever();
  text.replace(text.find("force = "), 8, "case = \"down\"\nforce = ");
  text += "case = \"down\"\n[[loads]]\nat = { id = 11 }\ncase = \"up\"\nforce = [0, 1e5, 0]\n";
  const std::string file = scratch.write("case.toml", text);
  const std::string dump = scratch.write("dump", cantilever_dump({1}));
  const Ended none = run_program({"compare", file, dump});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("2 load cases: down, up"));
  EXPECT_EQ(run_program({"compare", file, dump, "--load-case", "down"}).code, 0);
  EXPECT_EQ(run_program({"compare", file, dump, "--load-case", "up"}).code, 4);
  EXPECT_THAT(run_program({"compare", file, dump, "--load-case", "Up"}).err,
              HasSubstr("did you mean \"up\"?"));
}

TEST(CompareCommand, BadChoicesSayTheCure) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const std::string dump = scratch.write("dump", cantilever_dump({1}));
  const Ended both = run_program({"compare", file, dump, "--step", "0", "--every-step"});
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, HasSubstr("exclude each other"));
  EXPECT_THAT(run_program({"compare", file, dump, "--bond-columns", "a,b"}).err, HasSubstr("--bonds FILE"));
  EXPECT_THAT(run_program({"compare", file, dump, "--bonds", dump, "--bond-force", "fx,fy"}).err,
              HasSubstr("2 columns are named"));
  const Ended absent = run_program({"compare", file, (scratch / "none").string()});
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.err, HasSubstr("none"));
}

}  // namespace

}  // namespace bondstatic::test
