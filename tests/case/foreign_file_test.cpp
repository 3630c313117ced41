// Files of other codes where a case names a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/bond_law.hpp"
#include "case/same_model.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

using Files = std::vector<std::pair<std::string, std::string>>;

const std::string data =
    "three spheres\n\n3 atoms\n2 bonds\n2 atom types\n2 bond types\n\n"
    "-1 6 xlo xhi\n-2 2 ylo yhi\n-2 2 zlo zhi\n\n";
const std::string coefficients =
    "Bond Coeffs # bpm/rotational\n\n1 10 20 30 40 1 1 1 1 0 0 0 0\n2 11 21 31 41 1 1 1 1 0 0 0 0\n\n";
const std::string atoms =
    "Atoms # bpm/sphere\n\n5 1 1 2 2500 0 0 0\n6 1 1 2 2500 2 0 0\n9 1 2 2 2400 4 0 0\n\n";
const std::string bonds = "Bonds\n\n1 1 5 6\n2 2 6 9\n";

const std::string both = "[[particles]]\nfile = \"x.data\"\n[[bonds]]\nfile = \"x.data\"\n";
const std::string stiffness = "law = \"generic\"\nkn = 1\nks = 2\nkt = 3\nkb = 4\n";
const std::string rest =
    "[[supports]]\nat = { group = \"type 1\" }\nfix = \"all\"\n[[loads]]\nat = { group = \"type 2\" }\n"
    "force = [1, 0, 0]\n";

TEST(ForeignFile, IsReadAsATableOfTheSameModelWouldBe) {
  const Case direct = read_case_text(both + stiffness + rest, {}, {{"x.data", data + atoms + bonds}});
  const Case tables =
      read_case_text("[[particles]]\nfile = \"p.csv\"\n[[bonds]]\nfile = \"b.csv\"\n" + stiffness + rest, {},
                     {{"p.csv",
                       "id,x,y,z,radius,density,group\n5,0,0,0,1,2500,type 1\n6,2,0,0,1,2500,type 1\n"
                       "9,4,0,0,1,2400,type 2\n"},
                      {"b.csv", "id,a,b\n1,5,6\n2,6,9\n"}});
  expect_same(direct.model, tables.model);
}

TEST(ForeignFile, GivesItsStiffnessToEachBondAndNeedsNoLawThen) {
  const Case given = read_case_text(both + rest, {}, {{"x.data", data + coefficients + atoms + bonds}});
  EXPECT_EQ(given.model.blocks.at(0).law, "generic");
  EXPECT_THAT(given.resolved, HasSubstr("law = \"generic\""));
  const auto properties = bond_properties(given.model);
  EXPECT_EQ(properties[0].stiffness.kn, 10);
  EXPECT_EQ(properties[0].stiffness.ks, 20);
  EXPECT_EQ(properties[0].stiffness.kt, 30);
  EXPECT_EQ(properties[0].stiffness.kb, 40);
  EXPECT_EQ(properties[1].stiffness.kb, 41);
}

TEST(ForeignFile, UnderAnotherLawLosesItsStiffnessWithAWarning) {
  const Case given =
      read_case_text(both + "law = \"timoshenko\"\nyoung = 1e9\npoisson = 0.2\nradius = 1\n" + rest, {},
                     {{"x.data", data + coefficients + atoms + bonds}});
  EXPECT_TRUE(given.model.blocks.at(0).overrides.empty());
  EXPECT_THAT(given.warnings,
              Contains(AllOf(HasSubstr("x.data"), HasSubstr("left out"), HasSubstr("timoshenko"))));
  EXPECT_THAT(given.warnings, Contains(HasSubstr("strength_bending")));
}

TEST(ForeignFile, WithoutStiffnessNeedsALaw) {
  const auto faults = faults_of(both + rest, {}, {{"x.data", data + atoms + bonds}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 3);
  EXPECT_THAT(faults[0].message, HasSubstr("needs law"));
}

TEST(ForeignFile, TakesWhatTheBlockSaysOfIt) {
  const std::string hybrid =
      "Atoms # hybrid\n\n5 1 0 0 0 2 2500 1\n6 1 2 0 0 2 2500 1\n9 2 4 0 0 2 2400 1\n\n";
  const std::string text =
      "[[particles]]\nfile = \"x.data\"\natom_style = \"hybrid sphere bond\"\n[[bonds]]\nfile = "
      "\"x.data\"\natom_style = \"hybrid sphere bond\"\n";
  const Case direct = read_case_text(text + stiffness + rest, {}, {{"x.data", data + hybrid + bonds}});
  const Case plain = read_case_text(both + stiffness + rest, {}, {{"x.data", data + atoms + bonds}});
  expect_same(direct.model, plain.model);
}

TEST(ForeignFile, OfADumpHasTheStepThatIsAskedFor) {
  const auto step = [](int number, double x) {
    return "ITEM: TIMESTEP\n" + std::to_string(number) +
           "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z "
           "radius\n"
           "1 1 0 0 0 1\n2 1 " +
           std::to_string(x) + " 0 0 1\n";
  };
  const Files files{{"d.dump", step(0, 1.5) + step(100, 1.75)}};
  const std::string text = "[[particles]]\nfile = \"d.dump\"\n";
  const std::string bonded = "[[bonds]]\n" + stiffness;
  EXPECT_EQ(read_case_text(text + bonded, {}, files).model.particles.at(1).position.x(), 1.75);
  EXPECT_EQ(read_case_text(text + "step = 0\n" + bonded, {}, files).model.particles.at(1).position.x(), 1.5);
  EXPECT_THAT(faults_of(text + "step = 7\n" + bonded, {}, files),
              Contains(Field(&Fault::message, HasSubstr("7"))));
}

TEST(ForeignFile, BondColumnsOfALocalDumpAreNamedByTheBlock) {
  const std::string dump =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
      "ITEM: ENTRIES index c_1[1] c_1[2] c_2[1]\n1 5 6 0.5\n2 6 9 0.25\n";
  const Case given = read_case_text(
      "[[particles]]\nfile = \"x.data\"\n[[bonds]]\nfile = \"b.local\"\n"
      "bond_columns = [\"c_1[1]\", \"c_1[2]\"]\n" +
          stiffness + rest,
      {}, {{"x.data", data + atoms + bonds}, {"b.local", dump}});
  ASSERT_EQ(given.model.bonds.size(), 2u);
  EXPECT_EQ(given.model.bonds[1].a, 1);
  EXPECT_EQ(given.model.bonds[1].b, 2);
}

TEST(ForeignFile, ColumnContactPointIsEachBondsOwn) {
  const std::string text =
      "[[particles]]\nline = { from = [0, 0, 0], to = [2, 0, 0], count = 3 }\nradius = 0.5\n"
      "[[bonds]]\nfile = \"b.csv\"\ncontact_point = 0.5\n" +
      stiffness;
  const Case given = read_case_text(text, {}, {{"b.csv", "a,b,contact_point\n1,2,0.25\n2,3,\n"}});
  const auto properties = bond_properties(given.model);
  EXPECT_EQ(properties[0].fraction, 0.25);
  EXPECT_EQ(properties[1].fraction, 0.5);
  const auto faults = faults_of(text, {}, {{"b.csv", "a,b,contact_point\n1,2,1.25\n2,3,0\n"}});
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].place.line, 2);
  EXPECT_EQ(faults[0].place.column, 5);
  EXPECT_THAT(faults[0].message, HasSubstr("contact_point = 1.25 must lie between 0 and 1"));
}

TEST(ForeignFile, ATableWithAllFourStiffnessesNeedsNoLaw) {
  const std::string text =
      "[[particles]]\nline = { from = [0, 0, 0], to = [2, 0, 0], count = 3 }\nradius = 0.5\n"
      "[[bonds]]\nfile = \"b.csv\"\n";
  EXPECT_EQ(read_case_text(text, {}, {{"b.csv", "a,b,kn,ks,kt,kb\n1,2,1,2,3,4\n"}}).model.blocks.at(0).law,
            "generic");
  EXPECT_THAT(faults_of(text, {}, {{"b.csv", "a,b,kn,ks,kt\n1,2,1,2,3\n"}}),
              ElementsAre(Field(&Fault::message, HasSubstr("needs law"))));
}

TEST(ForeignFile, HeadingsOfWordsAreNoNamesOfThisProjectsColumns) {
  const Case given =
      read_case_text("[[particles]]\nfile = \"p.csv\"\n[[bonds]]\nfile = \"b.csv\"\n", {},
                     {{"p.csv",
                       "Particle ID,Position X (mm),Position Y (mm),Position Z (mm),Diameter (mm)\n"
                       "4,0,0,0,2\n7,2,0,0,2\n"},
                      {"b.csv",
                       "Particle A,Particle B,kn (kN/m),ks (kN/m),kt (N m),kb (N m)\n"
                       "4,7,1,2,3,4\n"}});
  ASSERT_EQ(given.model.bonds.size(), 1u);
  EXPECT_EQ(given.model.bonds[0].branch, Vector3(0.002, 0, 0));
  EXPECT_EQ(bond_properties(given.model).at(0).stiffness.kn, 1000);
  EXPECT_TRUE(given.si);
}

TEST(ForeignFile, OfBondsIsNotAtFaultWhereItsParticlesAre) {
  const std::string dump =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
      "ITEM: ENTRIES index c_1[1] c_1[2]\n1 5 6\n";
  const std::string text =
      "[[particles]]\nfile = \"p.csv\"\n[[bonds]]\nfile = \"b.local\"\n"
      "bond_columns = [\"c_1[1]\", \"c_1[2]\"]\n" +
      stiffness;
  EXPECT_THAT(faults_of(text, {}, {{"p.csv", "id,x,y,z,radius\n5,0,0,0,1\n6,1,0,0,-1\n"}, {"b.local", dump}}),
              ElementsAre(Field(&Fault::message, HasSubstr("must be positive"))));
}

struct Bad {
  const char* name;
  std::string text;  ///< of the file
  int line;
  const char* message;
};

class BadForeignFile : public testing::TestWithParam<Bad> {};

TEST_P(BadForeignFile, IsAFaultWithFileLineAndCure) {
  const Bad& row = GetParam();
  const auto faults = faults_of(both + stiffness + rest, {}, {{"x.data", row.text}});
  ASSERT_FALSE(faults.empty());
  EXPECT_THAT(faults,
              Contains(AllOf(Field(&Fault::message, HasSubstr(row.message)), Field(&Fault::cure, Not("")))));
  for (const Fault& fault : faults)
    if (fault.message.find(row.message) != std::string::npos) {
      EXPECT_EQ(fault.place.line, row.line);
      EXPECT_EQ(fault.place.file, row.line < 8 ? "case.toml" : "x.data");
    }
}

const Bad bad[] = {
    {"NoBonds", "three\n\n3 atoms\n2 atom types\n\n-1 6 xlo xhi\n-2 2 ylo yhi\n-2 2 zlo zhi\n\n" + atoms, 4,
     "has no bonds"},
    {"UnknownParticle", data + atoms + "Bonds\n\n1 1 5 6\n2 2 6 8\n", 21, "8"},
    {"NegativeDiameter",
     data + "Atoms # bpm/sphere\n\n5 1 1 -2 2500 0 0 0\n6 1 1 2 2500 2 0 0\n9 1 2 2 2400 4 0 0\n\n" + bonds,
     14, "-2"},
};

INSTANTIATE_TEST_SUITE_P(All, BadForeignFile, testing::ValuesIn(bad),
                         [](const auto& row) { return row.param.name; });

TEST(ForeignFile, WhoseBondsGoThroughPeriodicFacesNeedsACell) {
  // This project's own files say in their first line along which edges they repeat.
  const std::size_t first = data.find('\n'), box = data.find("-1 6");
  const std::string near =
      "boundary = p f f" + data.substr(first, box - first) + "0 4.5 xlo xhi\n-2 2 ylo yhi\n-2 2 zlo zhi\n\n";
  const std::string across = near + atoms + "Bonds\n\n1 1 5 9\n2 2 6 9\n";
  EXPECT_THAT(faults_of(both + stiffness + rest, {}, {{"x.data", across}}),
              ElementsAre(Field(&Fault::message, HasSubstr("1 of its bonds go through its faces"))));
  const Case given = read_case_text(
      "[cell]\nsize = [4.5, 4, 4]\norigin = [0, -2, -2]\nperiodic = [\"x\"]\n" + both + stiffness + rest, {},
      {{"x.data", across}});
  EXPECT_EQ(given.model.bonds.at(0).branch, Vector3(-0.5, 0, 0));
}

}  // namespace
}  // namespace bondstatic::test
