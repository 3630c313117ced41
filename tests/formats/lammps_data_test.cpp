#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

#include "formats/digest.hpp"
#include "formats/lammps/atom_style.hpp"
#include "formats/lammps/data.hpp"
#include "formats/lammps_samples.hpp"
#include "formats/malformed.hpp"

namespace bondstatic::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

ForeignModel sound(const std::string& text, const ReadOptions& options = {}) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  auto model = read_lammps_data(folder.write("a.data", text), options, named_at, faults);
  if (!model) throw InputError(faults);
  return *model;
}

DigestingReader reader_with(const ReadOptions& options = {}) {
  return digesting(read_lammps_data, options);
}

/// Header and two atoms of a style; `rows` are the section's.
std::string with_atoms(const std::string& style, const std::string& rows, const std::string& box = "") {
  return "title\n\n2 atoms\n2 atom types\n" +
         (box.empty() ? "0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n" : box) + "\nAtoms" + style + "\n\n" + rows;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in the sample");
  return text.replace(at, from.size(), to);
}

TEST(LammpsData, ReadsBpmSphereWithBondsAndCoefficients) {
  const ForeignModel model = sound(bpm_data);
  EXPECT_EQ(model.format, "LAMMPS data file (bpm/sphere)");
  EXPECT_TRUE(model.si);
  ASSERT_EQ(model.particles.size(), 3u);
  EXPECT_EQ(model.particles[0].id, 2);
  EXPECT_EQ(model.particles[0].radius, 0.55);  // the column is the diameter
  EXPECT_EQ(model.particles[0].density, 2500);
  EXPECT_EQ(model.particles[0].position, Vector3(3.75, 1.5, 2));
  EXPECT_THAT(model.particle_line, ElementsAre(19, 20, 21));
  EXPECT_THAT(model.group_names, ElementsAre("type 1", "type 2"));
  EXPECT_THAT(model.group, ElementsAre(1, 0, 0));
  ASSERT_EQ(model.bonds.size(), 2u);
  EXPECT_EQ(model.bonds[0].a, 1);
  EXPECT_EQ(model.bonds[0].b, 2);
  EXPECT_EQ(model.bonds[0].type, 2);
  EXPECT_THAT(model.bond_line, ElementsAre(31, 32));
}

TEST(LammpsData, CoefficientsTwistBeforeTheyBendInStiffnessAndInStrength) {
  const ForeignModel model = sound(bpm_data);
  EXPECT_THAT(model.bond_columns.at("kn"), ElementsAre(2e6, 1e6));
  EXPECT_THAT(model.bond_columns.at("ks"), ElementsAre(5e5, 4e5));
  EXPECT_THAT(model.bond_columns.at("kt"), ElementsAre(0.06, 0.05));
  EXPECT_THAT(model.bond_columns.at("kb"), ElementsAre(0.09, 0.08));
  EXPECT_THAT(model.kept_columns.at("strength_normal"), ElementsAre(11, 10));
  EXPECT_THAT(model.kept_columns.at("strength_twisting"), ElementsAre(31, 30));
  EXPECT_THAT(model.kept_columns.at("strength_bending"), ElementsAre(41, 40));
  EXPECT_THAT(model.kept_columns.at("damping_shear"), ElementsAre(0.6, 0.4));
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("normalize no")));
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("reference state")));
}

TEST(LammpsData, ImageFlagsAndBondsThroughFacesProveWhereTheBoxRepeats) {
  const ForeignModel model = sound(bpm_data);
  ASSERT_TRUE(model.cell);
  EXPECT_THAT(model.cell->periodic, ElementsAre(true, true, false));
  EXPECT_EQ(model.cell->origin, Vector3(0, 0, -1));
  EXPECT_EQ(model.cell->edges, Matrix3(Vector3(4, 5, 7).asDiagonal()));
  EXPECT_THAT(model.notes.assumed,
              Contains(HasSubstr("along its x edge: 1 particles have image flags that are not "
                                 "zero, 1 bonds fit")));
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("along its y edge: 1 particles")));
  ASSERT_TRUE(model.box);
  EXPECT_THAT(model.box->periodic, ElementsAre(false, false, false));

  std::string plain = changed(bpm_data, "1.5 2 0 0 0", "1.5 2");
  plain = changed(changed(plain, "2.0625 1 0 0", "2.0625"), "0.5 2 0 -1 0", "0.5 2");
  const ForeignModel bonds_only = sound(plain);
  EXPECT_THAT(bonds_only.cell->periodic, ElementsAre(true, false, false));
}

TEST(LammpsData, BondsThatMayCrossAFaceAreToldWhereNothingProvesIt) {
  const ForeignModel model = sound(with_atoms(" # bond", "1 1 1 0.5 1 1\n2 1 1 8.5 1 1\n\nBonds\n\n1 1 1 2\n",
                                              "1 bonds\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n"));
  EXPECT_FALSE(model.cell);
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("1 bonds are more than half the box long")));
}

TEST(LammpsData, TheTitleOfAnExportTellsTheBoundary) {
  const ForeignModel model = sound(changed(bpm_data, "units = si", "boundary = p f p, units = si"));
  EXPECT_THAT(model.cell->periodic, ElementsAre(true, false, true));
  EXPECT_TRUE(model.si);
}

TEST(LammpsData, WhatIsNotTakenIsTold) {
  const ForeignModel model = sound(bpm_data);
  EXPECT_THAT(model.notes.left_out, Contains("Section Velocities, 3 lines."));
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("molecule")));
  EXPECT_THAT(model.notes.taken, Contains("3 particles, atom style bpm/sphere."));
}

TEST(LammpsData, ReadsEveryStyleWithDiameters) {
  for (const auto& [style, rows] : std::vector<std::pair<std::string, std::string>>{
           {" # bpm/sphere", "1 5 1 2.5 2650 1 2 3\n2 5 2 1.5 2500 4 5 6\n"},
           {"   #   sphere/kk ", "1 1 2.5 2650 1 2 3  # a comment\n\n  2 2 1.5 2500 4 5 6\n"},
           {" # hybrid sphere bond", "1 1 1 2 3 2.5 2650 9\n2 2 4 5 6 1.5 2500 9\n"},
           {" # hybrid bond sphere 1", "1 1 1 2 3 9 2.5 2650\n2 2 4 5 6 9 1.5 2500\n"}}) {
    const ForeignModel model = sound(with_atoms(style, rows));
    ASSERT_EQ(model.particles.size(), 2u) << style;
    EXPECT_EQ(model.particles[0].radius, 1.25) << style;
    EXPECT_EQ(model.particles[1].density, 2500) << style;
    EXPECT_EQ(model.particles[1].position, Vector3(4, 5, 6)) << style;
    EXPECT_THAT(model.group, ElementsAre(0, 1)) << style;
    EXPECT_FALSE(model.si) << style;
  }
}

TEST(LammpsData, ColumnsOfAHybridStyleAreThoseOfTheDocumentation) {
  Fault wrong;
  EXPECT_THAT(find_atom_style("hybrid charge sphere", wrong)->columns,
              ElementsAre("id", "type", "x", "y", "z", "q", "diameter", "density"));
  EXPECT_THAT(find_atom_style("hybrid dipole full", wrong)->columns,
              ElementsAre("id", "type", "x", "y", "z", "q", "mux", "muy", "muz", "molecule"));
}

TEST(LammpsData, AStyleWithoutRadiiLeavesThemToBeGiven) {
  const ForeignModel model = sound(with_atoms(" # bond", "1 1 1 1 2 3\n2 1 2 4 5 6\n"));
  EXPECT_TRUE(std::isnan(model.particles[0].radius));
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("no radii")));
}

TEST(LammpsData, TheAtomStyleCanBeAskedFor) {
  ReadOptions options;
  options.atom_style = "hybrid sphere bond";
  for (const std::string comment : {"", " # hybrid"}) {
    const ForeignModel model =
        sound(with_atoms(comment, "1 1 1 2 3 2.5 2650 9 0 0 1\n2 2 4 5 6 1.5 2500 9 0 0 0\n"), options);
    EXPECT_EQ(model.particles[0].radius, 1.25);
    EXPECT_THAT(model.cell->periodic, ElementsAre(false, false, true));
  }
  options.atom_style = "sphere";
  EXPECT_THAT(sound(with_atoms(" # atomic", "1 1 2 1 1 2 3\n2 1 2 1 1 2 4\n"), options).notes.assumed,
              Contains(HasSubstr("although the file says \"atomic\"")));
}

TEST(LammpsData, ReadsTiltedAndGeneralBoxes) {
  const std::string rows = "1 1 1 1 2 3 1 1 0 0\n2 1 1 1 4 5 6 0 1 1\n";
  const ForeignModel tilted = sound(
      with_atoms(" # sphere", rows, "-1 5 xlo xhi\n0 9 ylo yhi\n0 8 zlo zhi\n0.5 -0.25 0.75 xy xz yz\n"));
  Matrix3 edges;
  edges << 6, 0.5, -0.25, 0, 9, 0.75, 0, 0, 8;
  EXPECT_EQ(tilted.cell->edges, edges);
  EXPECT_EQ(tilted.cell->origin, Vector3(-1, 0, 0));
  const ForeignModel general =
      sound(with_atoms(" # sphere", rows, "1 2 3 avec\n-2 1 0 bvec\n0 0.5 9 cvec\n1 2 3 abc origin\n"));
  edges << 1, -2, 0, 2, 1, 0.5, 3, 0, 9;
  EXPECT_EQ(general.cell->edges, edges);
  EXPECT_EQ(general.cell->origin, Vector3(1, 2, 3));
}

TEST(LammpsData, AStateIsUnwrappedByImageFlags) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto state = read_lammps_data_state(folder.write("a", bpm_data), {}, named_at, faults);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->step, 700);
  EXPECT_TRUE(state->unwrapped);
  EXPECT_THAT(state->id, ElementsAre(2, 1, 7));
  EXPECT_EQ(state->position[1], Vector3(4.5, 1.25, 2.0625));
  EXPECT_EQ(state->position[2], Vector3(3.5, -4.5, 2));
  EXPECT_THAT(state->radius, ElementsAre(0.55, 0.5, 0.45));
}

TEST(LammpsData, TypeLabelsStandForTypes) {
  const ForeignModel model = sound(
      "t\n\n2 atoms\n1 bonds\n2 atom types\n1 bond types\n\nAtom Type Labels\n\n1 rock\n2 sand\n\nBond Type "
      "Labels\n\n1 glue\n\nAtoms # sphere\n\n1 sand 1 1 0 0 0\n2 rock 1 1 0.25 0 0\n\nBonds\n\n1 glue 1 2\n");
  EXPECT_THAT(model.group, ElementsAre(1, 0));
  EXPECT_EQ(model.bonds[0].type, 1);
}

TEST(LammpsData, ATypeLabelIsOfOneType) {
  expect_fault(reader_with(),
               "t\n\n2 atoms\n2 atom types\n\nAtom Type Labels\n\n1 rock\n2 rock\n\nAtoms # sphere\n\n"
               "1 rock 1 1 0 0 0\n2 rock 1 1 0.25 0 0\n",
               "label \"rock\" is there twice", 9);
}

TEST(LammpsData, BrokenBondsAndRepeatedNumbersAreTold) {
  const ForeignModel model = sound(changed(bpm_data, "1 2 1 2\n2 1 2 7", "1 0 1 2\n2 1 2 7"));
  EXPECT_EQ(model.bonds.size(), 1u);
  EXPECT_THAT(model.notes.left_out, Contains("1 bonds of type 0, which are broken."));
  const ForeignModel repeated = sound(changed(bpm_data, "2 1 2 7", "1 1 2 7"));
  EXPECT_EQ(repeated.bonds[0].id, -1);
  EXPECT_THAT(repeated.notes.assumed, Contains(HasSubstr("numbered in their order")));
}

TEST(LammpsData, CoefficientsOfOtherStylesAreLeftOut) {
  const ForeignModel model =
      sound(changed(bpm_data, "Bond Coeffs # bpm/rotational", "Bond Coeffs # harmonic"));
  EXPECT_TRUE(model.bond_columns.empty());
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("(harmonic)")));
  const ForeignModel unnamed = sound(changed(bpm_data, "Bond Coeffs # bpm/rotational", "Bond Coeffs"));
  EXPECT_EQ(unnamed.bond_columns, sound(bpm_data).bond_columns);
  EXPECT_THAT(unnamed.notes.assumed, Contains(HasSubstr("they are twelve")));
}

TEST(LammpsData, OnlyWhatIsWantedIsRead) {
  ReadOptions options;
  options.particles = false;
  const ForeignModel bonds = sound(changed(bpm_data, "Atoms # bpm/sphere", "Atoms"), options);
  EXPECT_TRUE(bonds.particles.empty());
  EXPECT_EQ(bonds.bonds.size(), 2u);
  options = {};
  options.bonds = false;
  const ForeignModel particles = sound(bpm_data, options);
  EXPECT_EQ(particles.particles.size(), 3u);
  EXPECT_TRUE(particles.bonds.empty() && particles.bond_columns.empty());
}

TEST(LammpsData, ReadsThePackingOfARealRunToTheLastDigit) {
  const std::string path = std::string(BONDSTATIC_SOURCE_DIR) + "/cases/lammps-bpm/packing.data";
  std::vector<Fault> faults;
  const auto model = read_lammps_data(path, {}, named_at, faults);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->particles.size(), 2068u);
  EXPECT_EQ(model->bonds.size(), 6271u);
  EXPECT_FALSE(model->cell);
  // An independent reading of the same text, by the standard library's streams.
  std::istringstream text(read_text(path));
  std::string line;
  while (std::getline(text, line) && line != "Atoms # bpm/sphere") {
  }
  for (const Particle& particle : model->particles) {
    Index id = 0, molecule = 0, type = 0;
    double diameter = 0, density = 0, x = 0, y = 0, z = 0;
    text >> id >> molecule >> type >> diameter >> density >> x >> y >> z;
    ASSERT_EQ(particle.id, id);
    ASSERT_EQ(particle.radius, diameter / 2);
    ASSERT_EQ(particle.density, density);
    ASSERT_EQ(particle.position, Vector3(x, y, z));
  }
}

TEST(LammpsData, FaultsSayWhatIsWrongAndHowToCureIt) {
  const DigestingReader reader = reader_with();
  const auto with = [](const std::string& from, const std::string& to) {
    return changed(bpm_data, from, to);
  };
  struct Row {
    std::string text, mention;
    int line;
  };
  const std::vector<Row> rows{
      {with("Atoms # bpm/sphere", "Atoms"), "--atom-style \"bpm/sphere\"", 17},
      {with("Atoms # bpm/sphere", "Atoms # hybrid"), "--atom-style \"hybrid sphere bond\"", 17},
      {with("Atoms # bpm/sphere", "Atoms # bpm/spher"), "did you mean \"bpm/sphere\"", 17},
      {with("Atoms # bpm/sphere", "Atoms # sphere"), "image flags 10", 19},
      {with("Atoms # bpm/sphere\n\n", "Atoms # bpm/sphere\n"), "reads over the line", 18},
      {with("Atoms # bpm/sphere", "Atom # bpm/sphere"), "did you mean \"Atoms\"", 17},
      {with("3 atoms", "4 atoms"), "has 3 lines, but the header announces 4 atoms", 17},
      {with("3 atoms", "2 atoms"), "correct the header", 17},
      {with("3 atoms", "9223372036854775808 atoms"), "must be a whole number", 3},
      {with("3 atoms", "8000000000000000 atoms"), "has 3 lines", 17},
      {with("3 atoms", "-3 atoms"), "must be a whole number", 3},
      {with("3 atoms\n", ""), "header announces no atoms", 1},
      {with("2 bonds", "3 bonds"), "has 2 lines, but the header announces 3 bonds", 29},
      {bpm_data.substr(0, bpm_data.find("Bonds\n")), "no section Bonds", 5},
      {bpm_data.substr(0, bpm_data.find("Bond Coeffs")), "no section Atoms", 3},
      {with("2 bond types", "1 bond types"), "must be a whole number from 0 to 1", 31},
      {with("2 atom types", "1 atom types"), "atom type = \"2\" must be a whole number from 1 to 1", 19},
      {with("2 atom types", "2 atom tipes"), "did you mean \"atom types\"", 4},
      {with("0 4 xlo xhi", "4 0 xlo xhi"), "the box has no volume", 10},
      {with("0 4 xlo xhi", "0 xlo xhi"), "1 numbers before \"xlo xhi\", which takes 2", 8},
      {with("-1 6 zlo zhi", "nan 6 zlo zhi"), "zlo zhi = \"nan\" is not a number", 10},
      {with("-1 6 zlo zhi", "-1 6 zlo zhi\n1 0 0 avec\n0 1 0 bvec\n0 0 1 cvec"), "two boxes", 13},
      {with("-1 6 zlo zhi", "-1 6 zlo zhi\n1 2 3 abc origin"), "two boxes", 11},
      {with("0 5 ylo yhi", "0 4 xlo xhi"), "\"xlo xhi\" is there twice", 9},
      {with("1.1 2500", "-1.1 2500"), "diameter = -1.1 must be positive", 19},
      {with("1.1 2500", "0 2500"), "leave point particles out", 19},
      {with("1.1 2500", "1.1 0"), "density = 0 must be positive", 19},
      {with("3.75 1.5", "nan 1.5"), "x = \"nan\" is not a number", 19},
      {with("3.75 1.5", "1e400 1.5"), "x = 1e400 is not a finite double", 19},
      {with("7 1 1 0.9", "1 1 1 0.9"), "id 1 is there twice, first in line 20", 21},
      {with("2.0625 1 0 0", "2.0625"), "image flags in all lines of the section, or in none", 20},
      {with("1 2 1 2\n", "1 2 1 5\n"), "a bond of particle 5, which is not in the section Atoms", 31},
      {with("1 2 1 2\n", "1 2 1 1\n"), "a bond of particle 1 with itself", 31},
      {with("1 2 1 2\n", "1 2 1\n"), "3 fields where a bond has 4", 31},
      {with("1 2 1 2\n", "1 2 1.0 2\n"), "first atom = \"1.0\" must be a whole number", 31},
      {with("1 1e6 4e5", "2 1e6 4e5"), "bond type 2 has its coefficients twice", 15},
      {with("1 1e6 4e5", "1 -1e6 4e5"), "kn = -1000000 must not be negative", 14},
      {with("1 1e6 4e5 ", "1 1e6 "), "11 coefficients; bpm/rotational has 12", 14},
      {with("1 1e6 4e5 0.05 0.08 10 20 30 40 0.3 0.4 3e-8 4e-8\n", ""), "no line for bond type 1", 12},
      {bpm_data + "\nBonds\n\n", "\"Bonds\" is there twice", 34},
  };
  for (const Row& row : rows) expect_fault(reader, row.text, row.mention, row.line);
}

TEST(LammpsData, TellsAtMostTwentyOfAKind) {
  std::string rows, sections;
  for (int i = 0; i < 1000; ++i) {
    rows += "1 1 0 1 0 0 0\n";
    sections += "\nAtomz " + std::string(1, char('a' + i % 26)) + "\n1 2\n";
  }
  const Answer of_rows =
      read_damaged(reader_with(), changed(with_atoms(" # sphere", rows), "2 atoms", "1000 atoms"));
  EXPECT_FALSE(of_rows.digest);
  EXPECT_LE(of_rows.faults.size(), 22u);
  EXPECT_LE(read_damaged(reader_with(), bpm_data + sections).faults.size(), 44u);
}

TEST(LammpsData, BearsDamage) {
  expect_robust(reader_with(), bpm_data);
  ReadOptions options;
  options.atom_style = "hybrid sphere bond";
  expect_robust(reader_with(options),
                with_atoms(" # hybrid", "1 1 1 2 3 2.5 2650 9 0 0 1\n2 2 4 5 6 1.5 2500 9 0 0 0\n"));
}

}  // namespace
}  // namespace bondstatic::test
