// `translate` and `laws --codes` as a user runs them.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string case5 = BONDSTATIC_SOURCE_DIR "/cases/chen2022/case5.toml";

json answer(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return json::parse(ended.out);
}

/// Of all load cases and fields, the largest relative change with `convention`.
double largest(const json& answer, const char* convention) {
  double all = 0;
  for (const json& load_case : answer.at("load_cases"))
    for (const json& field : load_case.at("fields"))
      all = std::max(all, field.at(convention).at("largest").get<double>());
  return all;
}

void expect_near(double found, double expected, double relative) {
  EXPECT_NEAR(found, expected, relative * std::abs(expected));
}

TEST(Translate, OfAParallelBondToPfcChangesNothing) {
  const json pfc = answer({"translate", case5, "--to", "pfc-linearpbond"});
  for (const json& misfit : pfc.at("blocks").at(0).at("misfit")) EXPECT_LE(misfit.get<double>(), 1e-15);
  EXPECT_EQ(pfc.at("blocks").at(0).at("contact_point_moved"), 0);
  for (const char* convention : {"contact_point", "stiffness", "both"})
    EXPECT_LE(largest(pfc, convention), 1e-14) << convention;
}

TEST(Translate, OfABeamOfEqualParticlesToLammpsChangesNothing) {
  const ScratchFolder folder;
  const std::string file = folder.write("case.toml", cantilever());
  const json lammps = answer({"translate", file, "--to", "lammps-bpm-rotational"});
  for (const char* convention : {"contact_point", "stiffness", "both"})
    EXPECT_LE(largest(lammps, convention), 1e-13) << convention;
}

// With the contact point at mid-length, these bonds are Euler-Bernoulli's: F L^3 / 3EI.
TEST(Translate, OfUnequalParticlesToLammpsIsTheContactPointAtMidLength) {
  const json lammps = answer({"translate", case5, "--to", "lammps-bpm-rotational"});
  const json beam = answer({"solve", case5, "--set", "bonds.0.contact_point=\"beam\""});
  const double tip = 1e3 * 100e3 * 64 / (3 * 200e9 * std::numbers::pi * 0.0016 / 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const json& output = lammps.at("outputs").at(i);
    const double solved = beam.at("outputs").at(i).at("value");
    expect_near(output.at("both"), solved, 1e-14);
    expect_near(output.at("contact_point"), solved, 1e-14);
    expect_near(output.at("stiffness"), output.at("value"), 1e-14);
  }
  expect_near(lammps.at("outputs").at(0).at("both"), tip, 1e-13);
  EXPECT_LE(largest(lammps, "stiffness"), 1e-14);
  EXPECT_GT(largest(lammps, "contact_point"), 0.1);
}

// A beam twists by n M / kt; PFC has ks r^2 / 2 for kt, and bends as before.
TEST(Translate, OfABeamToPfcTwistsByTheStiffnessThatPfcTiesToShear) {
  const ScratchFolder folder;
  const std::string file = folder.write("case.toml", cantilever() + R"(
[[loads]]
at = { id = 11 }
moment = ["100 kN m", 0, 0]
[[outputs]]
name = "twist"
of = "rx"
at = { id = 11 }
)");
  const json pfc = answer({"translate", file, "--to", "pfc-linearpbond"});
  const double length = 0.4, r = 0.2, young = 200e9, poisson = 0.3, inertia = std::numbers::pi * 0.0016 / 4;
  const double phi = 20 * r * r * (1 + poisson) / (3 * length * length);
  const double ks = 12 * young * inertia / (length * length * length * (1 + phi));
  const json &tip = pfc.at("outputs").at(0), &twist = pfc.at("outputs").at(1);
  expect_near(tip.at("both"), tip.at("value"), 1e-13);
  expect_near(twist.at("value"), 10 * 100e3 * length * (1 + poisson) / (young * inertia), 1e-13);
  expect_near(twist.at("both"), 10 * 100e3 / (ks * r * r / 2), 1e-13);
  expect_near(twist.at("stiffness"), twist.at("both"), 1e-15);
  expect_near(pfc.at("blocks").at(0).at("stored").at("pb_rmul").at("lowest"), 1, 1e-15);
  expect_near(pfc.at("blocks").at(0).at("stored").at("pb_kn").at("highest"), young / length, 1e-14);
}

TEST(Translate, WithoutLoadsGivesTheParametersOnly) {
  const ScratchFolder folder;
  std::string text = cantilever();
  text.erase(text.find("[[supports]]"));
  const std::string file = folder.write("case.toml", text);
  EXPECT_FALSE(answer({"translate", file, "--to", "yade-cohfrict"}).contains("load_cases"));
  EXPECT_THAT(run_program({"translate", file, "--to", "yade-cohfrict"}).out, HasSubstr("nothing acts"));
}

TEST(Translate, SaysWhatItDoesNotCount) {
  const std::string beam =
      R"(bonds.0={ law = "timoshenko", young = 200e9, poisson = 0.3, radius = 0.2, gap = 1.6 })";
  const Ended ended = run_program({"translate", case5, "--to", "liggghts-bond-gran", "--set", beam});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("kn, ks, kb exactly; kt off by at most"));
  EXPECT_THAT(ended.out, HasSubstr("turned as a whole"));
  EXPECT_THAT(ended.out, HasSubstr("is not counted"));
  const json block = answer({"translate", case5, "--to", "liggghts-bond-gran"}).at("blocks").at(0);
  EXPECT_EQ(block.at("departing"), 2);
  EXPECT_EQ(block.at("departure"), 0.5);
  const Ended pfc = run_program({"translate", case5, "--to", "pfc-linearpbond"});
  EXPECT_THAT(pfc.out, Not(HasSubstr("is not counted")));
}

TEST(Translate, WritesEveryBond) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  const std::vector<std::string> command{"translate", case5, "--to", "lammps-bpm-rotational", "--out", out};
  EXPECT_EQ(run_program(command).code, 0);
  const std::string bonds = read_text(folder / "out/bonds.csv");
  EXPECT_THAT(bonds, testing::StartsWith("id,a,b,k_r,k_s,k_t,k_b\n1,1,2,12566370614."));
  EXPECT_EQ(std::count(bonds.begin(), bonds.end(), '\n'), 3);
  EXPECT_EQ(json::parse(read_text(folder / "out/translation.json")).at("code"), "lammps-bpm-rotational");
  EXPECT_EQ(run_program(command).code, 0) << "replaces its own files";
}

TEST(Translate, LeavesOtherBondTablesAlone) {
  const ScratchFolder folder;
  folder.write("bonds.csv", "mine\n");
  const Ended ended =
      run_program({"translate", case5, "--to", "pfc-linearpbond", "--out", folder.path().string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(read_text(folder / "bonds.csv"), "mine\n");
}

TEST(Translate, ToAnUnknownCodeNamesTheKnownOnes) {
  const Ended ended = run_program({"translate", case5, "--to", "yade-cohfrick"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean \"yade-cohfrict\"?"));
  EXPECT_THAT(ended.err, HasSubstr("musen-solid-bond"));
  EXPECT_EQ(run_program({"translate", case5}).code, 2);
}

TEST(LawsOfCodes, AreListedAndShownOneByOne) {
  const Ended all = run_program({"laws", "--codes"});
  EXPECT_EQ(all.code, 0);
  for (const char* name : {"pfc-linearpbond", "edem-bonding-v2", "lammps-bpm-rotational",
                           "liggghts-bond-gran", "yade-cohfrict", "musen-solid-bond"})
    EXPECT_THAT(all.out, HasSubstr(name));
  const json one = answer({"laws", "--codes", "pfc-linearpbond"});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.at(0).at("stored").at(0).at("name"), "pb_kn");
  EXPECT_EQ(one.at(0).at("stored").at(0).at("unit"), "Pa/m");
  const Ended unknown = run_program({"laws", "--codes", "pfc"});
  EXPECT_EQ(unknown.code, 2);
}

}  // namespace
}  // namespace bondstatic::test
