// Tables with a header line and EDEM's results exports.
#include "formats/table/foreign_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/bond_law.hpp"
#include "formats/digest.hpp"
#include "formats/malformed.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ForeignModel model_of(const std::string& text, const ReadOptions& options = {}) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto model = read_foreign_table(folder.write("table.csv", text), options, named_at, faults);
  EXPECT_TRUE(faults.empty()) << InputError(faults).what();
  return model.value_or(ForeignModel{});
}

std::vector<Fault> faults_of(const std::string& text, const ReadOptions& options = {}) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  EXPECT_FALSE(read_foreign_table(folder.write("table.csv", text), options, named_at, faults).has_value());
  return faults;
}

ParticleState state_of(const std::string& text) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto state = read_state_table(folder.write("table.csv", text), {}, named_at, faults);
  EXPECT_TRUE(faults.empty()) << InputError(faults).what();
  return state.value_or(ParticleState{});
}

const std::string particle_table =
    "id,x,y,z,radius,density,group\n1,0.5,0,0,0.25,2650,left\n7,1,-2e-3,0,0.125,2650,right\n";
const std::string bond_table =
    "id,a,b,kn,ks,kt,kb,contact_point,tensile_strength\n3,1,7,1e6,4e5,0.05,0.08,0.5,1e5\n4,7,9,2e6,,0.05,0."
    "08,0.25,\n";
const std::string edem_rows =
    "EDEM Data Export\nQUERIES\nQ01 : Particle ID:\n\nEXTRACTED DATA\n\nTIME: 0.1\nQ01 : Particle ID: 4 9\n"
    "Q02 : Particle Position X: 9 9\nQ03 : Particle Position Y: 9 9\nQ04 : Particle Position Z: 9 9\n"
    "Q05 : Particle Diameter: 9 9\n\nTIME: 0.25\nQ01 : Particle ID: 4 9\nQ02 : Particle Position X: 0.5 1\n"
    "Q03 : Particle Position Y: 0 -0.25\nQ04 : Particle Position Z: 2 3\nQ05 : Particle Diameter: 0.5 0.25\n";

TEST(ForeignTable, TakesThisProjectsParticles) {
  const ForeignModel model = model_of(particle_table);
  ASSERT_EQ(model.particles.size(), 2u);
  EXPECT_EQ(model.particles[1].id, 7);
  EXPECT_EQ(model.particles[1].position, Vector3(1, -2e-3, 0));
  EXPECT_EQ(model.particles[1].radius, 0.125);
  EXPECT_EQ(model.particles[1].density, 2650);
  EXPECT_THAT(model.group_names, ElementsAre("left", "right"));
  EXPECT_THAT(model.particle_line, ElementsAre(2, 3));
  EXPECT_FALSE(model.si);
}

TEST(ForeignTable, HonoursUnitsInHeadingsToTheLastDigit) {
  const ForeignModel model = model_of(
      "Particle ID;Position X (mm);Position Y [cm];Position Z (m);Diameter (um);Density "
      "(g/cm^3)\n1;2;3;4;6;2.65\n");
  ASSERT_EQ(model.particles.size(), 1u);
  EXPECT_EQ(model.particles[0].position, Vector3(0.002, 0.03, 4));
  EXPECT_EQ(model.particles[0].radius, 3e-6);
  EXPECT_DOUBLE_EQ(model.particles[0].density, 2650);
  EXPECT_TRUE(model.si);
}

TEST(ForeignTable, FindsTheHeaderBelowAPrefaceOrInAComment) {
  const ForeignModel below = model_of("PFC3D listing\nof balls\n\nid pos_x pos_y pos_z rad\n5 1 2 3 0.5\n");
  ASSERT_EQ(below.particles.size(), 1u);
  EXPECT_EQ(below.particles[0].id, 5);
  EXPECT_THAT(below.notes.left_out,
              ElementsAre(HasSubstr("2 lines above the header: \"PFC3D listing\" ...")));
  const ForeignModel comment = model_of("# made by hand\n# x y z r\n1 2 3 0.5\n4 5 6 0.5\n");
  ASSERT_EQ(comment.particles.size(), 2u);
  EXPECT_EQ(comment.particles[1].position, Vector3(4, 5, 6));
  EXPECT_EQ(comment.particles[0].id, -1);
}

TEST(ForeignTable, MakesRadiusAndDensityOfVolumeAndMass) {
  const double radius = 0.01, volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  const ForeignModel model = model_of("x,y,z,volume,mass\n0,0,0," + std::to_string(volume * 1e6) + "e-6," +
                                      std::to_string(volume * 2500 * 1e3) + "e-3\n");
  EXPECT_NEAR(model.particles.at(0).radius, radius, 1e-7);
  EXPECT_NEAR(model.particles.at(0).density, 2500, 0.5);
  EXPECT_THAT(model.notes.assumed, testing::Contains(HasSubstr("spheres with the volumes")));
}

TEST(ForeignTable, SaysWhatItLeavesOut) {
  EXPECT_THAT(model_of("id,x,y,z,radius,temperature\n1,0,0,0,1,300\n").notes.left_out,
              ElementsAre("Columns not taken: temperature."));
}

TEST(ForeignTable, TakesBondsAndKeepsStrengths) {
  const ForeignModel model = model_of(bond_table);
  ASSERT_EQ(model.bonds.size(), 2u);
  EXPECT_EQ(model.bonds[1].id, 4);
  EXPECT_EQ(model.bonds[1].a, 7);
  EXPECT_EQ(model.bonds[1].b, 9);
  EXPECT_EQ(model.bond_columns.at("kn")[1], 2e6);
  EXPECT_TRUE(std::isnan(model.bond_columns.at("ks")[1]));
  EXPECT_EQ(model.bond_columns.at("contact_point")[1], 0.25);
  EXPECT_EQ(model.kept_columns.at("tensile_strength")[0], 1e5);
  EXPECT_THAT(model.notes.left_out, ElementsAre("Kept, not used by a static solve: tensile_strength."));
}

TEST(ForeignTable, StiffnessPerAreaAndRadiusAreEdemsBond) {
  const ForeignModel model = model_of(
      "Particle ID 1,Particle ID 2,Bond Normal Stiffness (N/m^3),Bond Shear Stiffness (N/m^3),Bond Radius "
      "(mm)\n"
      "1,2,1e11,4e10,2\n");
  const double r = 2e-3, area = std::numbers::pi * r * r, polar = area * r * r / 2;
  EXPECT_NEAR(model.bond_columns.at("kn").at(0), 1e11 * area, 1e-15 * 1e11 * area);
  EXPECT_NEAR(model.bond_columns.at("ks").at(0), 4e10 * area, 1e-15 * 4e10 * area);
  EXPECT_NEAR(model.bond_columns.at("kt").at(0), 4e10 * polar, 1e-15 * 4e10 * polar);
  EXPECT_NEAR(model.bond_columns.at("kb").at(0), 1e11 * polar / 2, 1e-15 * 1e11 * polar);
  EXPECT_FALSE(model.bond_columns.contains("normal_stiffness"));
  EXPECT_THAT(model.notes.assumed, testing::Contains(HasSubstr("contact_point = \"gap\"")));
}

TEST(ForeignTable, NormalStiffnessInForcePerLengthIsTheWholeBonds) {
  const ForeignModel model = model_of("id1,id2,normal stiffness (kN/m),shear stiffness (kN/m)\n1,2,5,3\n");
  EXPECT_EQ(model.bond_columns.at("kn").at(0), 5000);
  EXPECT_EQ(model.bond_columns.at("ks").at(0), 3000);
}

TEST(ForeignTable, LawParametersStayWhatTheyAre) {
  EXPECT_EQ(model_of("a,b,young (GPa),poisson\n1,2,70,0.3\n").bond_columns.at("young").at(0), 70e9);
}

TEST(ForeignTable, UnitsOfAnglesSayNothingOfTheOthers) {
  const ForeignModel model = model_of("a,b,kn,ks,kt,kb,friction_angle (deg)\n1,2,1,2,3,4,180\n");
  EXPECT_FALSE(model.si);
  EXPECT_THAT(model.notes.assumed, testing::IsEmpty());
  EXPECT_DOUBLE_EQ(model.kept_columns.at("friction_angle").at(0), std::numbers::pi);
}

TEST(ForeignTable, VolumeThatMakesDensitiesIsTaken) {
  const ForeignModel model = model_of("x,y,z,radius,volume,mass\n0,0,0,1,4,2\n");
  EXPECT_EQ(model.particles.at(0).density, 0.5);
  EXPECT_THAT(model.notes.left_out, testing::IsEmpty());
}

TEST(EdemExport, LastTimeInRowsOfValues) {
  const ForeignModel model = model_of(edem_rows);
  ASSERT_EQ(model.particles.size(), 2u);
  EXPECT_EQ(model.particles[1].id, 9);
  EXPECT_EQ(model.particles[1].position, Vector3(1, -0.25, 3));
  EXPECT_EQ(model.particles[1].radius, 0.125);
  EXPECT_THAT(model.notes.assumed, testing::Contains(HasSubstr("no units")));
  EXPECT_EQ(state_of(edem_rows).time, 0.25);
}

TEST(EdemExport, TimesAreCountedFromOne) {
  ReadOptions options;
  options.step = 1;
  EXPECT_EQ(model_of(edem_rows, options).particles.at(0).position, Vector3(9, 9, 9));
  options.step = 3;
  EXPECT_THAT(faults_of(edem_rows, options).at(0).message, HasSubstr("no time 3 in the export, which has 2"));
}

TEST(EdemExport, ColumnsOfValues) {
  const ForeignModel model = model_of(
      "EXTRACTED DATA\nTIME:,0.4\n,Q01 : Particle ID:,Q02 : Particle Position X:,Q03 : Particle Position Y:,"
      "Q04 : Particle Position Z:\n,1,0.5,0,0\n,2,1.5,0,0.25\n");
  ASSERT_EQ(model.particles.size(), 2u);
  EXPECT_EQ(model.particles[1].position, Vector3(1.5, 0, 0.25));
}

TEST(EdemExport, QueriesOfDifferentLengthAreFaults) {
  const auto faults = faults_of(
      "TIME: 1\nQ01 : Particle ID: 1 2\nQ02 : Particle Position X: 1\nQ03 : Particle Position Y: 1 2\nQ04 : "
      "Particle Position Z: 1 2\n");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 3);
  EXPECT_THAT(faults[0].message, HasSubstr("has 1 values, \"Q01 : Particle ID\" 2"));
}

TEST(EdemExport, ColumnsWithGapsInDifferentRowsAreFaults) {
  const auto faults = faults_of(
      "TIME:,0.4\n,Q01 : Particle ID:,Q02 : Particle Position X:,Q03 : Particle Position Y:,"
      "Q04 : Particle Position Z:\n,1,0.5,0,0\n,2,,,\n,,1.5,0,0.25\n");
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_EQ(faults[0].place.line, 5);
  EXPECT_THAT(faults[0].message, HasSubstr("\"Q02 : Particle Position X\" has a value below an empty field"));
}

TEST(EdemExport, LinesOfManyQueriesAreReadInLinearTime) {
  std::string line = "TIME: 1\n";
  for (int i = 0; i < 100'000; ++i) line += "Q1:a,";
  EXPECT_THAT(faults_of(line + '\n').at(0).message, HasSubstr("is there twice in a block"));
}

TEST(EdemExport, WhatNeedNotBeGivenMayBeEmpty) {
  const ForeignModel model =
      model_of("TIME:,0.4\n,Q01 : IDfirst:,Q02 : IDsecond:,Q03 : Bond Strength:\n,1,2,\n,2,3,7\n,3,4,\n");
  ASSERT_EQ(model.bonds.size(), 3u);
  const auto& strength = model.kept_columns.at("bond_strength");
  EXPECT_TRUE(std::isnan(strength[0]) && std::isnan(strength[2]));
  EXPECT_EQ(strength[1], 7);
}

TEST(StateTable, PartOfADisplacementOrATurnIsAFault) {
  for (const char* text :
       {"id,x,y,z,ux,uy\n1,0,0,0,1,1\n", "id,x,y,z,rx\n1,0,0,0,1\n", "id,x,y,z,qw,qx,qy\n1,0,0,0,1,0,0\n"}) {
    const Answer answer = read_damaged(digesting(read_state_table), text);
    ASSERT_EQ(answer.faults.size(), 1u) << text;
    EXPECT_THAT(answer.faults[0].message, HasSubstr("lacks"));
    EXPECT_EQ(answer.faults[0].place.column, 10);
  }
}

TEST(StateTable, PartOfAnotherVectorIsNotedAsNotTaken) {
  const ParticleState state = state_of("id,x,y,z,fz\n1,0,0,0,5\n");
  EXPECT_TRUE(state.force.empty());
  EXPECT_THAT(state.notes, ElementsAre(HasSubstr("fz")));
}

TEST(StateTable, OwnResultsArePositionPlusDisplacement) {
  const ParticleState state =
      state_of("id,x,y,z,radius,ux,uy,uz,rx,ry,rz\n3,1,2,3,0.5,0.25,0,-0.5,0,0,0.5\n");
  ASSERT_EQ(state.id, std::vector<Index>{3});
  EXPECT_EQ(state.position[0], Vector3(1.25, 2, 2.5));
  EXPECT_TRUE(state.unwrapped);
  EXPECT_NEAR(
      state.orientation.at(0).angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vector3::UnitZ()))),
      0, 1e-15);
}

TEST(StateTable, OtherDisplacementsAreAlreadyInThePosition) {
  const ParticleState state =
      state_of("id x y z disp_x disp_y disp_z qw qx qy qz vx vy vz\n1 1 2 3 9 9 9 0 1 0 0 4 5 6\n");
  EXPECT_EQ(state.position.at(0), Vector3(1, 2, 3));
  EXPECT_EQ(state.orientation.at(0).x(), 1);
  EXPECT_EQ(state.velocity.at(0), Vector3(4, 5, 6));
}

TEST(StateTable, BondStateKeepsNumbersUnderTheFilesNames) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto state = read_bond_state_table(folder.write("b.csv", "a,b,normal_force,law\n1,2,3.5,generic\n"),
                                           {}, named_at, faults);
  ASSERT_TRUE(state && faults.empty());
  EXPECT_EQ(state->columns.size(), 1u);
  EXPECT_EQ(state->columns.at("normal_force").at(0), 3.5);
}

struct BadTable {
  std::string name, text;
  int line, column;
  std::string message;
};

class BadTables : public testing::TestWithParam<BadTable> {};

TEST_P(BadTables, EndWithPlaceAndCure) {
  const auto faults = faults_of(GetParam().text);
  ASSERT_EQ(faults.size(), 1u) << InputError(faults).what();
  EXPECT_THAT(faults[0].message, HasSubstr(GetParam().message));
  EXPECT_EQ(faults[0].place.line, GetParam().line);
  EXPECT_EQ(faults[0].place.column, GetParam().column);
  EXPECT_FALSE(faults[0].cure.empty());
}

INSTANTIATE_TEST_SUITE_P(
    ForeignTable, BadTables,
    testing::Values(
        BadTable{"Empty", "", 1, 1, "no rows"}, BadTable{"HeaderOnly", "id,x,y,z\n", 1, 1, "no rows"},
        BadTable{"NoZ", "id,x,y\n1,2,3\n", 1, 1, "no column z; found: id, x, y"},
        BadTable{"OneEnd", "a,kn\n1,2\n", 1, 1, "only one of the columns a, b"},
        BadTable{"NoHeader", "1,2,3\n", 1, 1, "the number 1 where a column name must be"},
        BadTable{"ShortRow", "x,y,z\n1,2\n", 2, 1, "the row has 2 fields, the header 3"},
        BadTable{"Word", "x,y,z\n1,2,a\n", 2, 5, "z = \"a\" is not a number"},
        BadTable{"TooLarge", "x,y,z\n1,2,1e400\n", 2, 5, "not a finite double"},
        BadTable{"Nan", "x,y,z\n1,nan,2\n", 2, 3, "y = \"nan\" is not a number"},
        BadTable{"EmptyField", "x,y,z\n1,,2\n", 2, 3, "y is empty"},
        BadTable{"NegativeRadius", "x,y,z,radius\n1,1,1,-2\n", 2, 7, "must be positive"},
        BadTable{"IdTwice", "id,x,y,z\n1,0,0,0\n1,1,1,1\n", 3, 1, "1 is there twice, first in line 2"},
        BadTable{"HalfId", "id,x,y,z\n1.5,0,0,0\n", 2, 1, "must be a whole number"},
        BadTable{"UnknownUnit", "x (parsec),y,z\n1,2,3\n", 1, 1, "unknown unit \"parsec\""},
        BadTable{"WrongUnit", "x (kg),y,z\n1,2,3\n", 1, 1, "not of this dimension"},
        BadTable{"TwoMeanings", "x,y,z,pos_x\n1,2,3,4\n", 1, 7, "\"x\" and \"pos_x\" mean the same"},
        BadTable{"ParameterTwice", "a,b,young,Young (GPa)\n1,2,1e9,70\n", 1, 11, "young is given twice"},
        BadTable{"TangentialKt", "a,b,kn,kt\n1,2,3,4\n", 1, 8, "kt is the twisting stiffness"}),
    [](const auto& test) { return test.param.name; });

class SoundTables : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(SoundTables, BearDamage) {
  expect_robust(digesting(read_foreign_table), GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(ForeignTable, SoundTables,
                         testing::Values(std::pair("Particles", particle_table),
                                         std::pair("Bonds", bond_table), std::pair("Edem", edem_rows)),
                         [](const auto& test) { return test.param.first; });

TEST(StateTable, BearsDamage) {
  expect_robust(digesting(read_state_table),
                "id,x,y,z,qw,qx,qy,qz\n1,0.5,0,0,1,0,0,0\n2,1.5,0,0,0.6,0.8,0,0\n");
}

}  // namespace
}  // namespace bondstatic::test
