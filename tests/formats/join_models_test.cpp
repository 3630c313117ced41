#include "formats/join_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// Particles 4, 7 and one without an id, in two groups.
ReadFile packing() {
  ReadFile file{"p.csv", {}};
  file.model.format = "particles";
  for (const Index id : {4, -1, 7})
    file.model.particles.push_back({id, Vector3(double(file.model.particles.size()), 0, 0), 0.5});
  file.model.particle_line = {2, 3, 4};
  file.model.group_names = {"left", "right"};
  file.model.group = {0, 1, 1};
  return file;
}

ReadFile bonds(std::vector<ForeignBond> list) {
  ReadFile file{"b.csv", {}};
  file.model.format = "bonds";
  for (std::size_t k = 0; k < list.size(); ++k) file.model.bond_line.push_back(int(k) + 2);
  file.model.bonds = std::move(list);
  return file;
}

std::vector<Fault> faults_of(std::vector<ReadFile> files) {
  std::vector<Fault> faults;
  EXPECT_FALSE(join_models(std::move(files), faults));
  return faults;
}

TEST(JoinModels, NumbersWhatHasNoIdBehindTheLargestOfAllFiles) {
  ReadFile more{"q.csv", {}};
  more.model.particles = {{20, Vector3(9, 0, 0), 0.5}, {-1, Vector3(8, 0, 0), 0.5}};
  std::vector<Fault> faults;
  const auto joined = join_models({packing(), more, bonds({{-1, 4, 7}, {3, 21, 22}})}, faults);
  ASSERT_TRUE(joined) << InputError(faults).what();
  std::vector<Index> ids;
  for (const Particle& particle : joined->model.particles) ids.push_back(particle.id);
  EXPECT_THAT(ids, ElementsAre(4, 21, 7, 20, 22));
  EXPECT_THAT(joined->model.group_names, ElementsAre("left", "right", ""));
  EXPECT_THAT(joined->model.group, ElementsAre(0, 1, 1, 2, 2));
  EXPECT_EQ(joined->model.bonds[0].id, 4);
}

TEST(JoinModels, KeepsColumnsBesideTheirBonds) {
  ReadFile stiff = bonds({{1, 4, 7}}), plain = bonds({{2, 4, 8}});
  stiff.model.bond_columns["kn"] = {5};
  plain.model.kept_columns["strength"] = {6};
  std::vector<Fault> faults;
  const auto joined = join_models({packing(), plain, stiff}, faults);
  ASSERT_TRUE(joined) << InputError(faults).what();
  const auto &kn = joined->model.bond_columns.at("kn"), &strength = joined->model.kept_columns.at("strength");
  ASSERT_EQ(kn.size(), 2u);
  ASSERT_EQ(strength.size(), 2u);
  EXPECT_TRUE(std::isnan(kn[0]) && std::isnan(strength[1]));
  EXPECT_EQ(kn[1], 5);
  EXPECT_EQ(strength[0], 6);
}

TEST(JoinModels, CountsBondsSideBySideInWhicheverDirection) {
  std::vector<Fault> faults;
  const auto joined = join_models({packing(), bonds({{-1, 4, 7}, {-1, 7, 4}, {-1, 4, 7}})}, faults);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->parallel_bonds, 2);
  EXPECT_EQ(joined->model.bonds.size(), 3u);
}

TEST(JoinModels, SaysWhichUnitsAreAssumed) {
  ReadFile si = packing();
  si.model.si = true;
  std::vector<Fault> faults;
  const auto mixed = join_models({si, bonds({{-1, 4, 7}})}, faults);
  ASSERT_TRUE(mixed);
  EXPECT_TRUE(mixed->model.si);
  EXPECT_THAT(mixed->model.notes.assumed, ElementsAre(HasSubstr("others (bonds) do not say theirs")));
  const auto plain = join_models({packing(), bonds({{-1, 4, 7}})}, faults);
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->model.si);
  EXPECT_THAT(plain->model.notes.assumed, IsEmpty());
}

TEST(JoinModels, FaultsNameFileAndLine) {
  const auto expect = [](const std::vector<Fault>& faults, const char* file, int line, const char* message) {
    ASSERT_EQ(faults.size(), 1u) << message;
    EXPECT_EQ(faults[0].place.file, file);
    EXPECT_EQ(faults[0].place.line, line);
    EXPECT_THAT(faults[0].message, HasSubstr(message));
    EXPECT_THAT(faults[0].cure, testing::Not(""));
  };
  expect(faults_of({packing(), bonds({{1, 4, 7}, {2, 4, 5}})}), "b.csv", 3, "no particle 5");
  expect(faults_of({packing(), bonds({{1, 4, 4}})}), "b.csv", 2, "particle 4 to itself");
  expect(faults_of({packing(), bonds({{1, 4, 7}, {1, 4, 8}})}), "b.csv", 3, "bond id 1 is there twice");
  ReadFile twice = packing();
  twice.model.particles[2].id = 4;
  expect(faults_of({twice}), "p.csv", 4, "particle id 4 is there twice");
  ReadFile without = packing();
  without.model.particles[1].radius = not_given;
  expect(faults_of({without}), "p.csv", 3, "particle 8 has no radius, others have");
  ReadFile nowhere = packing();
  nowhere.model.particles[0].position.y() = not_given;
  expect(faults_of({nowhere}), "p.csv", 2, "must be finite");
}

TEST(JoinModels, TellsTwentyFaultsOfAKindAndCountsTheOthers) {
  const auto faults = faults_of({packing(), bonds(std::vector<ForeignBond>(30, {-1, 4, 4}))});
  ASSERT_EQ(faults.size(), 21u);
  EXPECT_THAT(faults.back(), Field(&Fault::message, HasSubstr("10 more")));
}

}  // namespace
}  // namespace bondstatic::test
