#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/digest.hpp"
#include "formats/lammps/local.hpp"
#include "formats/lammps_samples.hpp"
#include "formats/malformed.hpp"

namespace bondstatic::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

ReadOptions columns(const std::vector<std::string>& names) {
  ReadOptions options;
  options.bond_columns = names;
  return options;
}

DigestingReader state_reader(const ReadOptions& options) {
  return digesting(read_lammps_local_state, options);
}

TEST(LammpsLocal, BondsAreInTheColumnsThatTheUserNames) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const std::string path = folder.write("dump", local_dump);
  const auto state = read_bond_state(path, columns({"c_bl[1]", "c_bl[2]", "c_bl[3]"}), named_at, faults);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->step, 1000);
  EXPECT_THAT(state->a, ElementsAre(1, 2, 1));
  EXPECT_THAT(state->b, ElementsAre(2, 3, 3));
  EXPECT_THAT(state->columns.at("c_bl[3]"), ElementsAre(1, 1, 2));
  EXPECT_THAT(state->columns.at("c_bf[1]"), ElementsAre(0.5, 0.25, -1e-3));
  EXPECT_EQ(state->columns.size(), 3u);
  const auto model = read_foreign_model(path, columns({"c_bl[1]", "c_bl[2]", "c_bl[3]"}), named_at, faults);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->bonds[2].type, 2);
  EXPECT_EQ(model->bonds[2].b, 3);
  EXPECT_THAT(model->bond_line, ElementsAre(10, 11, 12));
  EXPECT_THAT(model->notes.left_out, Contains(HasSubstr("index, c_bf[1]")));
}

TEST(LammpsLocal, WellKnownNamesSpeakForThemselves) {
  std::string text = local_dump;
  text.replace(text.find("c_bl[1] c_bl[2] c_bl[3]"), 23, "batom1 batom2 btype");
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto model = read_lammps_local(folder.write("dump", text), {}, named_at, faults);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->bonds[2].a, 1);
  EXPECT_EQ(model->bonds[2].type, 2);
}

TEST(LammpsLocal, ALabelMayStandForEntries) {
  std::string text = local_dump;
  text.replace(text.find("NUMBER OF ENTRIES"), 17, "NUMBER OF BONDS");
  text.replace(text.find("ITEM: ENTRIES"), 13, "ITEM: BONDS");
  const ScratchFolder folder;
  std::vector<Fault> faults;
  EXPECT_EQ(detect_format(folder.write("dump", text), named_at, faults), FileFormat::lammps_local);
  EXPECT_TRUE(
      read_lammps_local(folder.write("dump", text), columns({"c_bl[1]", "c_bl[2]"}), named_at, faults));
}

TEST(LammpsLocal, ReadsARealRun) {
  const std::string path = std::string(BONDSTATIC_SOURCE_DIR) + "/cases/lammps-bpm/dump.bonds";
  std::vector<Fault> faults;
  const auto state = read_bond_state(path, columns({"c_bl[1]", "c_bl[2]", "c_bl[3]"}), named_at, faults);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->a.size(), 6271u);
  EXPECT_EQ(state->a[0], 140);
  EXPECT_EQ(state->b[0], 142);
  EXPECT_EQ(state->columns.at("c_bf[1]")[0], 0.0021429980520887315);
  EXPECT_EQ(state->columns.at("c_bf[4]")[2], 1.7781276882842745e-05);
}

TEST(LammpsLocal, FaultsSayWhatIsWrongAndHowToCureIt) {
  expect_fault(state_reader({}), local_dump, "--bond-columns c_bl[1],c_bl[2]", 9);
  expect_fault(state_reader({}), local_dump, "index, c_bl[1], c_bl[2], c_bl[3], c_bf[1]", 9);
  expect_fault(state_reader(columns({"c_bl[1]", "c_bl[9]"})), local_dump, "no column \"c_bl[9]\"", 9);
  expect_fault(state_reader(columns({"c_bl[1]", "c_bl[1]"})), local_dump, "named twice", 9);
  expect_fault(state_reader(columns({"c_bl[1]"})), local_dump, "name two", 3);
  expect_fault(state_reader(columns({"c_bl[1]", "c_bf[1]"})), local_dump,
               "c_bf[1] = \"0.5\" must be a whole number", 10);
  expect_fault(state_reader(columns({"c_bl[1]", "c_bl[3]"})), local_dump, "a bond of particle 1 with itself",
               10);
  std::string more = local_dump;
  more.replace(more.find("ENTRIES\n3"), 9, "ENTRIES\n4");
  expect_fault(state_reader(columns({"c_bl[1]", "c_bl[2]"})), more, "cut short: 3 of its 4 rows", 1);
}

TEST(LammpsLocal, BearsDamage) {
  expect_robust(state_reader(columns({"c_bl[1]", "c_bl[2]", "c_bl[3]"})), local_dump);
}

}  // namespace
}  // namespace bondstatic::test
