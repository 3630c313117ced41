#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "formats/digest.hpp"
#include "formats/lammps/dump.hpp"
#include "formats/lammps/local.hpp"
#include "formats/lammps_samples.hpp"
#include "formats/malformed.hpp"

namespace bondstatic::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

ParticleState state_of(const std::string& text, const ReadOptions& options = {}) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  auto state = read_lammps_dump_state(folder.write("dump", text), options, named_at, faults);
  if (!state) throw InputError(faults);
  return *state;
}

ForeignModel model_of(const std::string& text) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  auto model = read_lammps_dump(folder.write("dump", text), {}, named_at, faults);
  if (!model) throw InputError(faults);
  return *model;
}

const DigestingReader state_reader = digesting(read_lammps_dump_state);
const DigestingReader model_reader = digesting(read_lammps_dump);

/// One step of an orthogonal box [0, 4] x [1, 3] x [-1, 1].
std::string step_with(const std::string& columns, const std::string& rows,
                      const std::string& letters = " pp ff ss", int count = 2) {
  return "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n" + std::to_string(count) + "\nITEM: BOX BOUNDS" +
         letters + "\n0 4\n1 3\n-1 1\nITEM: ATOMS " + columns + "\n" + rows;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.rfind(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in the sample");
  return text.replace(at, from.size(), to);
}

TEST(LammpsDump, TheLastStepIsTakenUnlessOneIsAskedFor) {
  const ParticleState last = state_of(custom_dump);
  EXPECT_EQ(last.step, 1000);
  EXPECT_EQ(last.time, 0.01);
  EXPECT_THAT(last.id, ElementsAre(2, 1));
  EXPECT_THAT(last.radius, ElementsAre(0.6, 0.5));
  EXPECT_THAT(last.type, ElementsAre(2, 1));
  EXPECT_EQ(last.velocity[0], Vector3(0.1, 0.2, 0.3));
  EXPECT_THAT(last.force, IsEmpty());
  EXPECT_THAT(last.notes, Contains(HasSubstr("Step 1000 was read, of 2 in the file")));
  ReadOptions options;
  options.step = 0;
  EXPECT_EQ(state_of(custom_dump, options).position[1], Vector3(2, 2, 3));
}

TEST(LammpsDump, ImagesOfATiltedBoxAreUnwrapped) {
  const ParticleState state = state_of(custom_dump);
  ASSERT_TRUE(state.cell);
  Matrix3 edges;
  edges << 6, 0.5, -1, 0, 5, 0, 0, 0, 6;
  EXPECT_EQ(state.cell->edges, edges);
  EXPECT_EQ(state.cell->origin, Vector3(0, 0, 0));
  EXPECT_THAT(state.cell->periodic, ElementsAre(true, true, false));
  EXPECT_TRUE(state.unwrapped);
  EXPECT_EQ(state.position[0], Vector3(2.75, 7, 3));
  EXPECT_EQ(state.position[1], Vector3(1.125 - 6, 2, 3));
}

TEST(LammpsDump, EveryVariantOfPositionsIsTheSamePlace) {
  const Vector3 first(5, 1.5, 0), second(0.5, 2, 0.5);  // the first has left through the upper face along x
  const auto check = [&](const std::string& columns, const std::string& rows, bool unwrapped) {
    const ParticleState state = state_of(step_with(columns, rows));
    EXPECT_EQ(state.position[0], unwrapped ? first : Vector3(first - Vector3(4, 0, 0))) << columns;
    EXPECT_EQ(state.position[1], second) << columns;
    EXPECT_EQ(state.unwrapped, unwrapped) << columns;
  };
  check("id x y z", "1 1 1.5 0\n2 0.5 2 0.5\n", false);
  check("id xu yu zu", "1 5 1.5 0\n2 0.5 2 0.5\n", true);
  check("id x y z ix iy iz", "1 1 1.5 0 1 0 0\n2 0.5 2 0.5 0 0 0\n", true);
  check("zs id type ys xs", "0.5 1 1 0.25 0.25\n0.75 2 1 0.5 0.125\n", false);
  check("id xs ys zs iz ix iy", "1 0.25 0.25 0.5 0 1 0\n2 0.125 0.5 0.75 0 0 0\n", true);
  check("id xsu ysu zsu", "1 1.25 0.25 0.5\n2 0.125 0.5 0.75\n", true);
  check("id x y z xu yu zu", "1 1 1.5 0 5 1.5 0\n2 0.5 2 0.5 0.5 2 0.5\n", true);
}

TEST(LammpsDump, WithoutPeriodicFacesNothingIsWrapped) {
  EXPECT_TRUE(state_of(step_with("id x y z", "1 1 1.5 0\n2 0.5 2 0.5\n", " ff sm mm")).unwrapped);
  EXPECT_FALSE(state_of(step_with("id x y z", "1 1 1.5 0\n2 0.5 2 0.5\n", " ff sm mm")).cell);
  const ParticleState unknown = state_of(step_with("id x y z", "1 1 1.5 0\n2 0.5 2 0.5\n", ""));
  EXPECT_FALSE(unknown.unwrapped);
  EXPECT_TRUE(model_of(step_with("id x y z", "1 1 1.5 0\n2 0.5 2 0.5\n", "")).box);
}

TEST(LammpsDump, AGeneralBoxIsReadByItsEdges) {
  const ParticleState state = state_of(
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n1 2 3 10\n-2 1 0 "
      "20\n0 0.5 9 30\nITEM: ATOMS id xs ys zs\n1 1 0 0\n");
  Matrix3 edges;
  edges << 1, -2, 0, 2, 1, 0.5, 3, 0, 9;
  EXPECT_EQ(state.cell->edges, edges);
  EXPECT_EQ(state.position[0], Vector3(11, 22, 33));
}

TEST(LammpsDump, QuaternionsAreFoundByNameOrByTheirValues) {
  const std::string rows = "1 0 2 0 0.8 0 0.6 0\n2 1 2 0 1 0 0 0\n";
  for (const std::string names : {"quatw quati quatj quatk", "quat1 quat2 quat3 quat4",
                                  "c_q[1] c_q[2] c_q[3] c_q[4]", "f_r[1] f_r[2] f_r[3] f_r[4]"}) {
    const ParticleState state = state_of(step_with("id x y z " + names, rows));
    ASSERT_EQ(state.orientation.size(), 2u) << names;
    EXPECT_NEAR(state.orientation[0].w(), 0.8, 1e-16);
    EXPECT_NEAR(state.orientation[0].y(), 0.6, 1e-16);
    const bool guessed = names[1] == '_';
    EXPECT_EQ(state.notes.size(), guessed ? 3u : 2u) << names;
  }
  // Four columns among more, such as the six of a stress, are none.
  const ParticleState behind_stress =
      state_of(step_with("id x y z c_s[1] c_s[2] c_s[3] c_s[4] c_s[5] c_s[6] c_q[1] c_q[2] c_q[3] c_q[4]",
                         "1 0 2 0 9 8 7 6 5 4 0.8 0 0.6 0\n2 1 2 0 9 8 7 6 5 4 0 1 0 0\n"));
  ASSERT_EQ(behind_stress.orientation.size(), 2u);
  EXPECT_NEAR(behind_stress.orientation[0].w(), 0.8, 1e-16);
  EXPECT_THAT(
      state_of(step_with("id x y z c_s[1] c_s[2] c_s[3] c_s[4]", "1 0 2 0 0.8 0 0.6 0\n2 1 2 0 1 1 0 0\n"))
          .orientation,
      IsEmpty());
  expect_fault(state_reader,
               step_with("id x y z quatw quati quatj quatk", "1 0 2 0 0.8 0 0.6 0\n2 1 2 0 1 1 0 0\n"),
               "squares do not add up to one", 9);
}

TEST(LammpsDump, IsAModelWhereItHasRadii) {
  const ForeignModel model = model_of(custom_dump);
  EXPECT_EQ(model.format, "LAMMPS dump");
  EXPECT_TRUE(model.si);  // although the units stand above the first step only
  EXPECT_THAT(model.notes.assumed, Not(Contains(HasSubstr("does not say its units"))));
  EXPECT_EQ(model.particles[0].radius, 0.6);
  EXPECT_EQ(model.particles[0].density, 2500);
  EXPECT_THAT(model.group_names, ElementsAre("type 1", "type 2"));
  EXPECT_THAT(model.group, ElementsAre(1, 0));
  EXPECT_TRUE(model.cell);
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("vx, vy, vz")));
  const ForeignModel by_mass =
      model_of(step_with("x y z diameter mass", "0 2 0 2 12.566370614359172\n1 2 0 2 1\n"));
  EXPECT_EQ(by_mass.particles[0].id, -1);
  EXPECT_EQ(by_mass.particles[0].radius, 1);
  EXPECT_NEAR(by_mass.particles[0].density, 3, 1e-15);
  EXPECT_TRUE(std::isnan(model_of(step_with("id x y z", "1 0 2 0\n2 1 2 0\n")).particles[0].radius));
}

TEST(LammpsDump, ListsItsWholeSteps) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  EXPECT_THAT(*dump_steps(folder.write("dump", custom_dump), named_at, faults), ElementsAre(0, 1000));
  const std::string cut = custom_dump.substr(0, custom_dump.size() - 10);
  EXPECT_THAT(*dump_steps(folder.write("dump", cut), named_at, faults), ElementsAre(0));
  EXPECT_THAT(*dump_steps(folder.write("local", local_dump), named_at, faults), ElementsAre(1000));
  EXPECT_TRUE(faults.empty());
  EXPECT_FALSE(dump_steps(folder.write("a.data", bpm_data), named_at, faults));
  EXPECT_THAT(faults.at(0).message, HasSubstr("no steps"));
}

TEST(LammpsDump, AStepCutShortIsAFaultAndTheOneBeforeItCanBeTaken) {
  ReadOptions first;
  first.step = 0;
  const std::string whole = digest(state_of(custom_dump, first));
  const std::size_t second = custom_dump.find("ITEM: TIME\n0.01");
  for (std::size_t at = second + 1; at < custom_dump.size(); ++at) {
    const std::string cut = custom_dump.substr(0, at);
    expect_fault(state_reader, cut, "--step 0");
    EXPECT_EQ(digest(state_of(cut, first)).substr(0, 200), whole.substr(0, 200)) << at;
    if (testing::Test::HasFailure()) return;
  }
  expect_fault(state_reader, custom_dump.substr(0, second - 5), "no step of the file is whole");
}

TEST(LammpsDump, ARunThatWasKilledAndWentOnLeavesAShortStepInside) {
  const std::size_t row = custom_dump.find("2 2 0.6 2500 2 2 3");
  const std::string text = custom_dump.substr(0, row) + custom_dump;
  EXPECT_EQ(state_of(text).step, 1000);
  ReadOptions options;
  options.step = 0;  // there twice, short and whole
  EXPECT_THAT(state_of(text, options).notes, Contains(HasSubstr("several times")));
}

TEST(LammpsDump, ReadsARealRun) {
  const std::string path = std::string(BONDSTATIC_SOURCE_DIR) + "/cases/lammps-bpm/dump.final";
  std::vector<Fault> faults;
  const auto state = read_particle_state(path, {}, named_at, faults);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->step, 150000);
  EXPECT_EQ(state->id.size(), 2068u);
  EXPECT_EQ(state->orientation.size(), 2068u);
  EXPECT_TRUE(state->unwrapped);
  EXPECT_FALSE(state->cell);
  std::istringstream text(read_text(path));
  std::string line;
  while (std::getline(text, line) && !line.starts_with("ITEM: ATOMS")) {
  }
  for (std::size_t i = 0; i < 2068; ++i) {
    Index id = 0, type = 0;
    double x = 0, y = 0, z = 0, q[4];
    text >> id >> type >> x >> y >> z >> q[0] >> q[1] >> q[2] >> q[3];
    ASSERT_EQ(state->id[i], id);
    ASSERT_EQ(state->position[i], Vector3(x, y, z));
    ASSERT_NEAR(state->orientation[i].x(), q[1], 1e-16);
    ASSERT_NEAR(state->orientation[i].z(), q[3], 1e-16);
  }
}

TEST(LammpsDump, FaultsSayWhatIsWrongAndHowToCureIt) {
  const auto with = [](const std::string& from, const std::string& to) {
    return changed(custom_dump, from, to);
  };
  struct Row {
    std::string text, mention;
    int line;
  };
  const std::vector<Row> rows{
      {with("1 1 0.5 2650 1.125", "1 1 0.5 1.125"), "12 fields in a row of 13 columns", 28},
      {with("1 1 0.5 2650 1.125", "2 1 0.5 2650 1.125"), "id 2 is there twice, first in line 27", 28},
      {with("1 1 0.5 2650 1.125", "1.5 1 0.5 2650 1.125"), "id = \"1.5\" must be a whole number", 28},
      {with("1 1 0.5 2650 1.125", "1 1 -0.5 2650 1.125"), "radius = -0.5 must be positive", 28},
      {with("0.5 2650 1.125", "0.5 2650 nan"), "x = \"nan\" is not a number", 28},
      {with("0.5 2650 1.125", "0.5 2650 1e400"), "x = 1e400 is not a finite double", 28},
      {with("ITEM: ATOMS id type", "ITEM: ATOMS mol type"), "no column id", 26},
      {with("ITEM: ATOMS id type", "ITEM: ATOMS id id"), "\"id\" is there twice", 26},
      {with(" x y z ix", " x y zed ix"), "the dump has no positions", 26},
      {with("NUMBER OF ATOMS\n2", "NUMBER OF ATOMS\n1"), "must begin or go on", 28},
      {with("NUMBER OF ATOMS\n2", "NUMBER OF ATOMS\n3"), "cut short: 2 of its 3 rows are there", 16},
      {with("NUMBER OF ATOMS\n2", "NUMBER OF ATOMS\n9223372036854775808"), "must be one whole number", 21},
      {with("NUMBER OF ATOMS\n2", "NUMBER OF ATOMS\n8000000000000000"),
       "cut short: 2 of its 8000000000000000", 16},
      {with("TIMESTEP\n1000", "TIMESTEP\n1e3"), "must be one whole number", 19},
      {with("-1 6.5 0.5", "6.5 -1 0.5"), "the box has no volume", 25},
      {with("-1 6.5 0.5", "-1 6.5"), "must have 3 numbers", 23},
      {with("ITEM: BOX BOUNDS", "ITEM: BOXES"), "where \"ITEM: ATOMS\"", 22},
  };
  for (const Row& row : rows) expect_fault(state_reader, row.text, row.mention, row.line);
  const ScratchFolder folder;
  std::vector<Fault> faults;
  ReadOptions options;
  options.step = 7;
  EXPECT_FALSE(read_lammps_dump_state(folder.write("dump", custom_dump), options, named_at, faults));
  EXPECT_THAT(faults.at(0).message, HasSubstr("has no step 7"));
  EXPECT_THAT(faults.at(0).cure, HasSubstr("0, 1000"));
  EXPECT_EQ(faults.at(0).place.file, "case.toml");
}

TEST(LammpsDump, BearsDamage) {
  expect_robust(state_reader, custom_dump);
  expect_robust(model_reader, custom_dump);
}

}  // namespace
}  // namespace bondstatic::test
