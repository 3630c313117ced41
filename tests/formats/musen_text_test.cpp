#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/digest.hpp"
#include "formats/malformed.hpp"
#include "formats/musen/text.hpp"

namespace bondstatic::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

// Two spheres, a sound bond, one that broke at 0.5, and a wall; times 0 and 1; a periodic box; a material of
// three words. After ExportAsText.cpp of MUSEN.
const std::string scene =
    "0 0 1 1 5 0.002 0.002 23 GLASS 24 0 1e+300 2 0 12 0 0 0 15 0 0 0 31 1 0 0 0 2 1 12 0 0 1e-05 15 0 0 3 "
    "31 0.6 0.8 0 0 \n"
    "0 3 1 1 5 0.001 0.001 23 GLASS 24 0 1e+300 2 0 12 0.004 0 0 15 0 0 0 31 1 0 0 0 2 1 12 0.004 0 0 15 0 0 "
    "0 31 1 0 0 0 \n"
    "0 5 1 9 5 0 3 0.0016 0.0032 23 GLUE 24 0 1e+300 2 0 20 0 0 0 2 1 20 1 0 0 \n"
    "0 6 1 9 5 0 3 0.0016 0.004 23 GLUE 24 0 0.5 2 0 20 0 0 0 2 1 20 0 0 0 \n"
    "0 9 1 14 5  23 STEEL 24 0 1e+300 2 0 2 1 \n"
    "22 -1 -1 -1 1 1 1 \n"
    "28 1 1 0 0 0 0 0 0.01 0.02 0.03 \n"
    "29 1 \n"
    "32 GLUE old hide glue 0 1100 7 1e+09 8 1e+06 9 2e+06 10 0.25 \n"
    "32 GLASS Glass 0 2500 7 5e+10 10 0.2 \n";

std::optional<ForeignModel> read(const std::string& text, std::vector<Fault>& faults,
                                 const ReadOptions& options = {}) {
  const ScratchFolder folder;
  return read_musen_text(folder.write("scene.txt", text), options, named_at, faults);
}

TEST(MusenText, SpheresAtTheLastTime) {
  std::vector<Fault> faults;
  const auto model = read(scene, faults);
  ASSERT_TRUE(model) << InputError(faults).what();
  ASSERT_EQ(model->particles.size(), 2u);
  EXPECT_EQ(model->particles[0].position, Vector3(0, 0, 1e-5));
  EXPECT_EQ(model->particles[1].id, 3);
  EXPECT_EQ(model->particles[1].radius, 0.001);
  EXPECT_EQ(model->particles[1].density, 2500);
  EXPECT_EQ(model->group_names.at(std::size_t(model->group[1])), "Glass");
  EXPECT_TRUE(model->si);
  ASSERT_TRUE(model->cell);
  EXPECT_EQ(model->cell->edges(0, 0), 0.01);
  EXPECT_THAT(model->cell->periodic, ElementsAre(true, false, false));
}

TEST(MusenText, BondsHaveTheStiffnessOfTheElasticModel) {
  std::vector<Fault> faults;
  const auto model = read(scene, faults);
  ASSERT_TRUE(model);
  ASSERT_EQ(model->bonds.size(), 1u);
  EXPECT_EQ(model->bonds[0].id, 5);
  EXPECT_EQ(model->bonds[0].b, 3);
  const double r = 0.0008, length = 0.0032, area = std::numbers::pi * r * r, second = area * r * r / 4;
  const double young = 1e9, shear = young / 2.5;
  const auto at = [&](const char* name) { return model->bond_columns.at(name).at(0); };
  EXPECT_DOUBLE_EQ(at("kn"), young * area / length);
  EXPECT_DOUBLE_EQ(at("ks"), shear * area / length);
  EXPECT_DOUBLE_EQ(at("kt"), 2 * shear * second / length);
  EXPECT_DOUBLE_EQ(at("kb"), young * second / length);
  EXPECT_EQ(at("contact_point"), 0.5);
  EXPECT_EQ(model->kept_columns.at("normal_strength").at(0), 1e6);
  EXPECT_THAT(model->notes.left_out,
              Contains(HasSubstr("1 spheres and bonds that are not active at time 1")));
  EXPECT_THAT(model->notes.left_out, Contains("walls: 1."));
}

TEST(MusenText, AnEarlierTimeHasTheBondThatBrokeLater) {
  std::vector<Fault> faults;
  ReadOptions options;
  options.step = 1;
  const auto model = read(scene, faults, options);
  ASSERT_TRUE(model) << InputError(faults).what();
  EXPECT_EQ(model->bonds.size(), 2u);
  EXPECT_EQ(model->particles[0].position, Vector3::Zero());
  options.step = 3;
  EXPECT_FALSE(read(scene, faults, options));
  EXPECT_THAT(faults.at(0).message, HasSubstr("no time 3"));
}

TEST(MusenText, StateHasOrientationsSinceTheFirstTime) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  const auto state = read_musen_state(folder.write("scene.txt", scene), {}, named_at, faults);
  ASSERT_TRUE(state) << InputError(faults).what();
  EXPECT_EQ(state->time, 1);
  EXPECT_THAT(state->id, ElementsAre(0, 3));
  EXPECT_EQ(state->velocity.at(0), Vector3(0, 0, 3));
  EXPECT_NEAR(state->orientation.at(0).x(), 0.8, 1e-15);
}

TEST(MusenText, WithoutMaterialsTheLawIsTheUsers) {
  std::vector<Fault> faults;
  const auto model = read(scene.substr(0, scene.find("32 GLUE")), faults);
  ASSERT_TRUE(model);
  EXPECT_FALSE(model->bond_columns.contains("kn"));
  EXPECT_EQ(model->bond_columns.at("radius").at(0), 0.0008);
  EXPECT_THAT(model->notes.left_out, Contains(HasSubstr("Stiffness of bonds")));
}

TEST(MusenText, FaultsSayWhereAndWhat) {
  const DigestingReader reader = digesting(read_musen_text);
  expect_fault(reader, scene + "99 1 2\n", "99 begins no line", 11);
  expect_fault(reader, scene + "0 8 1 1 5 0.1\n", "the line ends where", 11);
  expect_fault(reader, scene + "0 8 1 77 5 0.1\n", "type 77 of an object is unknown", 11);
  expect_fault(reader, scene + "0 8 5 1 1\n", "before the type", 11);
  expect_fault(reader, scene + "0 3 1 1 5 1 1 2 1 12 0 0 0\n", "3 is there twice", 11);
  expect_fault(reader, scene + "0 8 1 1 5 1 1 2 0 12 0 0 0 2 1\n", "object 8: no coordinates at time 1", 11);
  expect_fault(reader, "22 0 0 0 1 1 1\n", "no spheres", 1);
  expect_robust(reader, scene);
}

}  // namespace
}  // namespace bondstatic::test
