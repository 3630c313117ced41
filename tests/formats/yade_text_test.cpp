#include "formats/yade_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "formats/digest.hpp"
#include "formats/malformed.hpp"

namespace bondstatic::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::optional<ForeignModel> read(const std::string& text, std::vector<Fault>& faults) {
  const ScratchFolder folder;
  return read_yade_text(folder.write("spheres.txt", text), {}, named_at, faults);
}

ForeignModel model_of(const std::string& text) {
  std::vector<Fault> faults;
  const auto model = read(text, faults);
  EXPECT_TRUE(faults.empty()) << InputError(faults).what();
  return model.value_or(ForeignModel{});
}

// As written by YADE 2023.02a.
const std::string with_material =
    "#format id_x_y_z_r_matId\n# spheres\n0\t0\t0\t0\t1\t2\n4\t1.9\t0.1\t0\t0.95\t3\n";

TEST(YadeText, ExportTextHasNoIds) {
  const ForeignModel model = model_of("#format x_y_z_r\n0\t0\t0\t1\n1.9\t0.1\t-1e-05\t0.95\n");
  ASSERT_EQ(model.particles.size(), 2u);
  EXPECT_EQ(model.particles[1].position, Vector3(1.9, 0.1, -1e-5));
  EXPECT_EQ(model.particles[1].radius, 0.95);
  EXPECT_EQ(model.particles[1].id, -1);
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("six digits")));
  EXPECT_THAT(model.notes.assumed, Contains(HasSubstr("no ids")));
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("yade.py")));
}

TEST(YadeText, IdsAndMaterials) {
  const ForeignModel model = model_of(with_material);
  EXPECT_EQ(model.particles.at(1).id, 4);
  EXPECT_THAT(model.group_names, ElementsAre("material 2", "material 3"));
}

TEST(YadeText, AttributesAreNamedByTheLastComment) {
  const ForeignModel model = model_of("#format x_y_z_r_attrs\n# x y z r mass contacts\n0\t0\t0\t1\t5\t12\n");
  EXPECT_EQ(model.particles.at(0).radius, 1);
  EXPECT_NEAR(model.particles.at(0).density, 5 / (4.0 / 3 * std::numbers::pi), 1e-15);
  EXPECT_THAT(model.notes.left_out, Contains(HasSubstr("contacts")));
  EXPECT_EQ(model_of("#format x_y_z_r_attrs\n0\t0\t0\t1\t5\t6\n").particles.size(), 1u);
}

TEST(YadeText, FormatsWithoutSpheresAreFaults) {
  std::vector<Fault> faults;
  EXPECT_FALSE(read("#format jointedPM\n1 2 3\n", faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 1);
  EXPECT_THAT(faults[0].message, HasSubstr("\"jointedPM\" has no columns x, y, z, r"));
  EXPECT_THAT(faults[0].cure, HasSubstr("yade.py"));
}

TEST(YadeText, BearsDamage) {
  expect_robust(digesting(read_yade_text), with_material);
}

}  // namespace
}  // namespace bondstatic::test
