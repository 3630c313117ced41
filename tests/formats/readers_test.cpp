#include "formats/readers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/digest.hpp"
#include "formats/lammps_samples.hpp"
#include "formats/malformed.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

TEST(Readers, FormatsShowInTheFirstLines) {
  const ScratchFolder folder;
  const auto format_of = [&](const std::string& text) {
    std::vector<Fault> faults;
    return detect_format(folder.write("file", text), named_at, faults);
  };
  EXPECT_EQ(format_of(bpm_data), FileFormat::lammps_data);
  EXPECT_EQ(format_of("3 atoms\nin the title only\n"), FileFormat::table);
  EXPECT_EQ(format_of("title\n\n  0 1 xlo xhi # box\n"), FileFormat::lammps_data);
  EXPECT_EQ(format_of(custom_dump), FileFormat::lammps_dump);
  EXPECT_EQ(format_of(local_dump), FileFormat::lammps_local);
  EXPECT_EQ(format_of("#format x_y_z_r\n1 2 3 4\n"), FileFormat::yade_text);
  EXPECT_EQ(format_of("id,x,y,z,radius\n1,0,0,0,1\n"), FileFormat::table);
  EXPECT_EQ(format_of(""), FileFormat::table);
  EXPECT_EQ(format_of("ITEM: TIMESTEP\n0\n"), FileFormat::lammps_dump);  // cut short
}

TEST(Readers, EachQuestionIsRefusedByFormatsThatCannotAnswerIt) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  EXPECT_FALSE(read_particle_state(folder.write("local", local_dump), {}, named_at, faults));
  EXPECT_THAT(faults.at(0).message, HasSubstr("LAMMPS local dump, which has no particles with ids"));
  EXPECT_FALSE(read_bond_state(folder.write("dump", custom_dump), {}, named_at, faults));
  EXPECT_THAT(faults.at(1).message, HasSubstr("LAMMPS dump, which has no bonds of a step"));
  EXPECT_EQ(faults.at(1).place.line, named_at.line);
}

TEST(Readers, ProgressGoesFromNothingToAllAndMayGiveUp) {
  const ScratchFolder folder;
  std::string rows;
  for (int i = 1; i <= 60'000; ++i) rows += std::to_string(i) + " 1 1 2650 0.5 0.5 0.5\n";
  const std::string path = folder.write(
      "a.data",
      "t\n\n60000 atoms\n1 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n" + rows);
  std::vector<double> parts;
  ReadOptions options;
  options.progress = [&](double part) { parts.push_back(part); };
  std::vector<Fault> faults;
  EXPECT_TRUE(read_foreign_model(path, options, named_at, faults));
  EXPECT_GE(parts.size(), 4u);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.back(), 1);
  options.progress = [](double) { throw std::runtime_error("stop"); };
  EXPECT_THROW(read_foreign_model(path, options, named_at, faults), std::runtime_error);
}

}  // namespace
}  // namespace bondstatic::test
