#include "bondstatic/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bondstatic/bond_law.hpp"
#include "case/same_model.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

double parameter(const Case& c, const std::string& name) {
  const BondBlock& block = c.model.blocks.at(0);
  return block.parameters.at(std::size_t(find_bond_law(block.law)->find(name)));
}

TEST(CaseFile, ReadsTheReferenceCantilever) {
  const Case c = read_case(BONDSTATIC_SOURCE_DIR "/cases/cantilever/case.toml");
  EXPECT_EQ(c.title, "Chen et al. 2022, case 1: reference cantilever");
  ASSERT_EQ(c.model.particles.size(), 11u);
  for (Index i = 0; i < 11; ++i) {
    const Particle& particle = c.model.particles[std::size_t(i)];
    EXPECT_EQ(particle.id, i + 1);
    EXPECT_EQ(particle.position, Vector3(double(i) * 4 / 10, 0, 0));
    EXPECT_EQ(particle.radius, 0.2);
  }
  ASSERT_EQ(c.model.bonds.size(), 10u);
  for (Index i = 0; i < 10; ++i) {
    const Bond& bond = c.model.bonds[std::size_t(i)];
    EXPECT_EQ(bond.id, i + 1);
    EXPECT_EQ(bond.a, i);
    EXPECT_EQ(bond.b, i + 1);
    EXPECT_EQ(bond.branch,
              c.model.particles[std::size_t(i + 1)].position - c.model.particles[std::size_t(i)].position);
  }
  EXPECT_EQ(c.model.blocks.at(0).law, "timoshenko");
  EXPECT_EQ(parameter(c, "young"), 200e9);
  ASSERT_EQ(c.model.supports.size(), 1u);
  EXPECT_EQ(c.model.supports[0].fixed, (std::array<bool, 6>{true, true, true, true, true, true}));
  ASSERT_EQ(c.model.loads.size(), 1u);
  EXPECT_EQ(c.model.loads[0].particle, 10);
  EXPECT_EQ(c.model.loads[0].force, (Vector6() << 0, -100e3, 0, 0, 0, 0).finished());
  EXPECT_EQ(c.model.load_cases, std::vector<std::string>{""});
  ASSERT_EQ(c.outputs.size(), 1u);
  EXPECT_EQ(c.outputs[0].at, std::vector<Index>{10});
  EXPECT_FALSE(c.si);
  EXPECT_TRUE(c.warnings.empty());
  // F L^3 / 3EI + 10 F L / 9GA, first in double here, then in 40 digits
  const double area = std::numbers::pi * 0.04, second = area * 0.01, g = 200e9 / 2.6;
  EXPECT_NEAR(*c.outputs[0].expected, -(1e5 * 64 / (3 * 200e9 * second) + 10 * 1e5 * 4 / (9 * g * area)),
              1e-17);
  EXPECT_EQ(*c.outputs[0].expected, -0.0085342417262387425);
}

TEST(CaseFile, UnitsMakeTheSameModelInSi) {
  const Case plain = read_case_text(sound_case());
  const Case units = read_case_text(sound_case({
      {2, "line = { from = [0, 0, 0], to = [\"400 cm\", 0, 0], count = 11 }"},
      {3, "radius = \"200 mm\""},
      {6, "young = \"200 GPa\""},
      {14, "force = [0, \"-100 kN\", 0]"},
  }));
  expect_same(plain.model, units.model);
  EXPECT_FALSE(plain.si);
  EXPECT_TRUE(units.si);
}

TEST(CaseFile, SettingsReplaceAndAdd) {
  const Case c =
      read_case_text(sound_case(), {"bonds.0.young=70e9", "particles.0.line.to.0=8",
                                    "particles.0.radius=\"400 mm\"", "bonds.0.radius=+.25",
                                    "solve.unsupported=drop", "title=Two words", "loads.0.at={ id = 5 }",
                                    "outputs.0.at.id=[5]", "bonds.0.poisson=0.1", "bonds.0.poisson=0.2"});
  EXPECT_EQ(parameter(c, "young"), 70e9);
  EXPECT_EQ(parameter(c, "poisson"), 0.2);  // the last one holds
  EXPECT_EQ(c.model.particles.back().position.x(), 8);
  EXPECT_EQ(c.model.particles.back().radius, 0.4);
  EXPECT_EQ(c.solve.unsupported, Unsupported::drop);
  EXPECT_EQ(c.title, "Two words");
  EXPECT_EQ(c.model.loads.at(0).particle, 4);
  EXPECT_EQ(c.outputs.at(0).at, std::vector<Index>{4});
}

TEST(CaseFile, ReadsHowToSolve) {
  const Case c =
      read_case_text(sound_case({{19,
                                  "[solve]\nsolver = \"eigen\"\ntolerance = 1e-10\nunsupported = \"drop\"\n"
                                  "memory_limit = \"1.5 GiB\"\nthreads = 3"}}));
  EXPECT_EQ(c.solve.solver, "eigen");
  EXPECT_EQ(c.solve.tolerance, 1e-10);
  EXPECT_EQ(c.solve.unsupported, Unsupported::drop);
  EXPECT_EQ(c.solve.memory_limit, 1.5 * 1024 * 1024 * 1024);
  EXPECT_EQ(c.solve.threads, 3);
}

TEST(CaseFile, ByteOrderMarkAndCrlfAreTolerated) {
  std::string text = sound_case();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\r\n");
  expect_same(read_case_text("\xEF\xBB\xBF" + text).model, read_case_text(sound_case()).model);
}

/// A case with a bit of everything.
const char* const rich_case = R"(
title = "say \"hello\"\t\\ µ"
[[particles]]
file = "packing.csv"
density = "2.65 g/cm3"
group = ["grains", "all of it"]
[[particles]]
helix = { radius = 0.1, pitch = "5 cm", turns = 1.3, count = 7, centre = [0.3, 0, 1], start = [1, 1, 0] }
radius = 0.07
jitter = 0.1
removal = 0.2
seed = 5
group = "coil"
[[groups]]
name = "left"
at = { box = { max = [0.25, inf, inf] } }
[[bonds]]
law = "edem-v2"
normal_stiffness = 1e9
shear_stiffness = 0.333333333333333333
normal_range = 1e7
torque_feedback = false
file = "bonds.csv"
contact_point = "contact-radii"
contact_radius_factor = 1.25
[[bonds]]
law = "parallel"
young = "7 GPa"
poisson = 0.1
contact_radius_factor = 1.2
between = "coil"
existing = "skip"
contact_point = 0.3
[[supports]]
at = { group = "left", lowest = { axis = [0, 1, 1], within = "1 cm" } }
fix = ["x", "rz"]
values = { z = "-0.1 mm", ry = "1 deg" }
case = "second"
[[loads]]
gravity = [0, 0, -9.81]
[[loads]]
at = { all = true }
total_force = [1, 2, 3]
total_moment = [0, 0.1, 0]
case = "first"
[[outputs]]
name = "energy of bonds"
of = "energy"
at = { bond = [3, 7] }
reduce = "sum"
case = "first"
scale = 1e3
[[outputs]]
name = "all energy"
of = "energy"
case = "second"
expected = 0.1
tolerance = 0.5
)";
const std::vector<std::pair<std::string, std::string>> rich_files{
    {"packing.csv", "x, y, z, radius, id\n0,0,0,0.1,10\n0.2,0,0,0.1,4\n0.4,0,0.001,0.1,7\n"},
    {"bonds.csv", "id a b normal_stiffness # comment\n3 10 4 1e8\n7 4 7 2.5e9\n"}};

TEST(ResolvedCase, ReadsAsTheSameModelBitForBit) {
  const ScratchFolder folder;
  for (const auto& [name, content] : rich_files) folder.write(name, content);
  const std::string elsewhere = (folder / "results/deep").string();
  const Case first =
      read_case(folder.write("case.toml", rich_case), {"bonds.1.young=\"6.9 GPa\""}, elsewhere);
  std::filesystem::create_directories(elsewhere);
  const Case again =
      read_case(folder.write("results/deep/case.resolved.toml", first.resolved), {}, elsewhere);
  expect_same(first.model, again.model);
  EXPECT_EQ(first.resolved, again.resolved);
  EXPECT_EQ(first.title, again.title);
  EXPECT_EQ(first.si, again.si);
  ASSERT_EQ(first.outputs.size(), again.outputs.size());
  for (std::size_t i = 0; i < first.outputs.size(); ++i) {
    EXPECT_EQ(first.outputs[i].at, again.outputs[i].at);
    EXPECT_EQ(first.outputs[i].load_case, again.outputs[i].load_case);
    EXPECT_EQ(first.outputs[i].tolerance, again.outputs[i].tolerance);
  }
  EXPECT_THAT(first.resolved, testing::HasSubstr("file = \"../../packing.csv\""));
}

TEST(ResolvedCase, HasDefaultsAndSettings) {
  const Case c = read_case_text(sound_case({{8, ""}}), {"bonds.0.young=70e9"});
  for (const char* line :
       {"young = 70000000000.0\n", "radius_factor = 1.0\n", "gap = 0.0\n", "existing = \"error\"\n",
        "[solve]\nsolver = \"auto\"\n", "reduce = \"value\"\n", "tolerance = 1e-09\n"})
    EXPECT_THAT(c.resolved, testing::HasSubstr(line));
}

TEST(ResolvedCase, LeavesPathsAloneWithoutAFolder) {
  const ScratchFolder folder;
  for (const auto& [name, content] : rich_files) folder.write(name, content);
  const Case c = read_case(folder.write("case.toml", rich_case));
  EXPECT_THAT(c.resolved, testing::HasSubstr("file = \"packing.csv\""));
}

TEST(ResolvedCase, HoldsForTheCasesOfTheRepository) {
  for (const char* name : {"cantilever/case.toml", "yade-packing/loads.toml", "yade-packing/press.toml"}) {
    const ScratchFolder folder;
    const Case first =
        read_case(std::string(BONDSTATIC_SOURCE_DIR "/cases/") + name, {}, folder.path().string());
    const Case again = read_case(folder.write("case.resolved.toml", first.resolved));
    expect_same(first.model, again.model);
  }
}

TEST(YadePacking, HasTheBondsAndPlatensOfTheSource) {
  const Case c = read_case(BONDSTATIC_SOURCE_DIR "/cases/yade-packing/loads.toml");
  EXPECT_EQ(c.model.particles.size(), 2068u);
  EXPECT_EQ(c.model.bonds.size(), 6271u);
  EXPECT_EQ(c.model.supports.size(), 100u);
  EXPECT_EQ(c.model.loads.size(), 2 * 96u);
  EXPECT_EQ(c.model.load_cases, (std::vector<std::string>{"compression", "shear"}));
  EXPECT_EQ(c.solve.unsupported, Unsupported::drop);
}

}  // namespace
}  // namespace bondstatic::test
