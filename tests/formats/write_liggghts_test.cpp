#include <gmock/gmock.h>

#include "formats/export_models.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

/// Touching spheres of one size, under a parallel bond: what bond_style gran was made for.
Model touching_chain(double density) {
  Model model =
      chain(block("pfc-parallel", {{"normal_stiffness", 3e9}, {"shear_stiffness", 1e9}, {"radius", 0.1}}),
            Vector3::Zero(), Vector3(0.8, 0, 0), 4, 0.1);
  for (Particle& particle : model.particles) particle.density = density;
  load(model, 4, vector6(0, 0, -1));
  return model;
}

TEST(LiggghtsExport, CoefficientsCarryAParallelBondOfTouchingSpheres) {
  const Exported exported(touching_chain(2000), "liggghts");
  EXPECT_THAT(exported.notes.not_expressed, testing::IsEmpty());
  EXPECT_THAT(joined(exported.notes.remarks), HasSubstr("0.995"));
  const std::string deck = exported.text("in.liggghts");
  std::vector<std::string> line;
  for (const auto& words : command_lines(deck))
    if (words[0] == "bond_coeff") line = words;
  ASSERT_EQ(line.size(), 8u);
  // Its moments grow with half of the relative rotation: the section is larger by the square root of two, and
  // softer, so that kn = Sn pi r^2 and kb = Sn pi r^4 / 8 come out.
  const double rb = std::stod(line[2]) * 0.1, normal = std::stod(line[3]), shear = std::stod(line[4]);
  const SectionStiffness& wanted = exported.properties[0].stiffness;
  EXPECT_NEAR(normal * EIGEN_PI * rb * rb / wanted.kn, 1, 1e-14);
  EXPECT_NEAR(shear * EIGEN_PI * rb * rb / wanted.ks, 1, 1e-14);
  EXPECT_NEAR(normal * EIGEN_PI * std::pow(rb, 4) / 8 / wanted.kb, 1, 1e-14);
  EXPECT_NEAR(shear * EIGEN_PI * std::pow(rb, 4) / 4 / wanted.kt, 1, 1e-14);
}

TEST(LiggghtsExport, AtomsHaveTheColumnsOfGranularAndThenOfBonds) {
  const Exported exported(touching_chain(not_given), "liggghts");
  EXPECT_THAT(exported.text("model.data"), HasSubstr("\n2 2 0.2 0 0 0.2 1 1\n"));
  EXPECT_THAT(exported.text("model.data"), HasSubstr("\nBonds\n\n1 1 1 2\n"));
  EXPECT_THAT(joined(exported.notes.remarks), HasSubstr("density 1"));
}

TEST(LiggghtsExport, SaysWhichBondsGoToAnotherImageThanTheNearest) {
  EXPECT_THAT(joined(Exported(skewed_pair(), "liggghts").notes.not_expressed),
              HasSubstr("1 of 1 bonds do not go to the one nearest image"));
}

TEST(LiggghtsExport, SaysWhatItCannotCarry) {
  const Exported exported(mixed_model(), "liggghts", true);
  EXPECT_THAT(joined(exported.notes.not_expressed),
              testing::AllOf(HasSubstr("twisting or bending stiffness"), HasSubstr("do not touch"),
                             HasSubstr("start without stress")));
}

}  // namespace
}  // namespace bondstatic::test
