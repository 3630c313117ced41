// A model's bonds in another code's numbers, and the models that take over its conventions.
#include "bond/translate.hpp"

#include "bond/bond_fixture.hpp"
#include "bond/contact_point.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

const Values beam{{"young", 1e9}, {"poisson", 0.25}, {"radius", 0.1}};
const Values parallel{{"young", 1e9}, {"kappa", 2.5}, {"radius", 0.1}};

/// Three particles of radii 0.2, 0.4, 0.3 with gaps.
Model unequal(const BondBlock& block) {
  Model model;
  model.blocks = {block};
  add_particle(model, {0, 0, 0}, 0.2);
  add_particle(model, {0.7, 0, 0}, 0.4);
  add_particle(model, {0.7, 0.9, 0}, 0.3);
  add_bond(model, 0, 1);
  add_bond(model, 1, 2);
  return model;
}

Translation translated(const Model& model, const std::string& code) {
  return translate(model, *find_bond_code(code));
}

void expect_exact(const Model& model, const Translation& translation) {
  for (const BlockFit& fit : block_fits(model, translation))
    for (const double misfit : fit.misfit) EXPECT_LE(misfit, 1e-15);
}

void expect_equal(const BondProperties& left, const BondProperties& right) {
  EXPECT_EQ(left.stiffness.kn, right.stiffness.kn);
  EXPECT_EQ(left.stiffness.ks, right.stiffness.ks);
  EXPECT_EQ(left.stiffness.kt, right.stiffness.kt);
  EXPECT_EQ(left.stiffness.kb, right.stiffness.kb);
  EXPECT_EQ(left.stiffness.coupling, right.stiffness.coupling);
  EXPECT_EQ(left.fraction, right.fraction);
}

TEST(Translation, OfAParallelBondToPfcChangesNothing) {
  const Model model = unequal(block("parallel", parallel));
  expect_exact(model, translated(model, "pfc-linearpbond"));
  const BlockFit fit = block_fits(model, translated(model, "pfc-linearpbond")).front();
  EXPECT_EQ(fit.moved, 0);
  EXPECT_EQ(fit.bonds, 2);
  EXPECT_EQ(fit.coupled, 0);
}

TEST(Translation, TakesOverTheContactPointAlone) {
  const Model model = unequal(block("parallel", parallel));
  const Translation translation = translated(model, "lammps-bpm-rotational");
  const auto here = bond_properties(model);
  const auto there = bond_properties(as_realised(model, translation, Convention::contact_point));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(there[k].fraction, 0.5);
    EXPECT_NE(here[k].fraction, 0.5);
    EXPECT_EQ(there[k].stiffness.kb, here[k].stiffness.kb);
    EXPECT_EQ(there[k].radius, here[k].radius);
  }
  EXPECT_NEAR(block_fits(model, translation).front().moved, 0.1 / 0.7, 1e-15);
}

TEST(Translation, TakesOverTheStiffnessAlone) {
  const Model model = unequal(block("timoshenko", beam));
  const Translation translation = translated(model, "yade-cohfrict");
  const auto here = bond_properties(model);
  const auto there = bond_properties(as_realised(model, translation, Convention::stiffness));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(there[k].fraction, here[k].fraction);
    EXPECT_NEAR(there[k].stiffness.ks, here[k].stiffness.ks, 1e-15 * here[k].stiffness.ks);
    EXPECT_EQ(there[k].stiffness.kt, here[k].stiffness.kt);
  }
}

TEST(Translation, TakesOverBoth) {
  const Model model = unequal(block("timoshenko", beam));
  const Translation translation = translated(model, "pfc-linearpbond");
  const auto there = bond_properties(as_realised(model, translation, Convention::both));
  for (std::size_t k = 0; k < 2; ++k) expect_equal(there[k], translation.realised[k]);
  const BlockFit fit = block_fits(model, translation).front();
  for (const std::size_t exact : {0, 1, 3}) EXPECT_LE(fit.misfit[exact], 1e-14);
  EXPECT_GT(fit.misfit[2], 0.1);
}

// Moving a stepped section's contact point moves its stiffness along: nothing changes but what is then lost.
TEST(Translation, MovesSteppedSectionsBeforeItLosesTheirCoupling) {
  const Model model =
      unequal(block("two-segment", {{"young", 1e9}, {"poisson", 0.25}, {"radius_factor", 0.5}}));
  const Translation translation = translated(model, "lammps-bpm-rotational");
  EXPECT_EQ(block_fits(model, translation).front().coupled, 2);
  const auto here = bond_properties(model);
  const auto point = bond_properties(as_realised(model, translation, Convention::contact_point));
  const auto stiffness = bond_properties(as_realised(model, translation, Convention::stiffness));
  for (std::size_t k = 0; k < 2; ++k) {
    const double length = model.bonds[k].branch.norm();
    const SectionStiffness moved_here = moved(here[k].stiffness, (0.5 - here[k].fraction) * length);
    EXPECT_EQ(point[k].stiffness.kb, moved_here.kb);
    EXPECT_EQ(point[k].stiffness.coupling, moved_here.coupling);
    EXPECT_EQ(stiffness[k].fraction, 0.5);
    EXPECT_EQ(stiffness[k].stiffness.kb, moved_here.kb);
    EXPECT_EQ(stiffness[k].stiffness.coupling, 0);
  }
}

TEST(Translation, KeepsMomentsInTheBondWhereEdemDoes) {
  const Model model = unequal(block(
      "edem-v2",
      {{"normal_stiffness", 1e10}, {"shear_stiffness", 4e9}, {"normal_range", 1e9}, {"torque_feedback", 0}}));
  const Translation translation = translated(model, "edem-bonding-v2");
  const auto here = bond_properties(model);
  const auto there = bond_properties(as_realised(model, translation, Convention::both));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_FALSE(there[k].moments_fed_back);
    EXPECT_NEAR(there[k].stiffness.kn, here[k].stiffness.kn, 1e-15 * here[k].stiffness.kn);
    EXPECT_NEAR(there[k].stiffness.kb, here[k].stiffness.kb, 2e-15 * here[k].stiffness.kb);
    EXPECT_EQ(there[k].fraction, here[k].fraction);
  }
  expect_exact(model, translation);
  const Translation lammps = translated(model, "lammps-bpm-rotational");
  EXPECT_EQ(lammps.stored[3], std::vector<double>({0, 0}));
  expect_exact(model, lammps);
}

TEST(Translation, OfAContactBondToPfcSaysThatMomentsCome) {
  const Model model = unequal(block("contact", {{"kn", 7}, {"ks", 5}}));
  const BlockFit fit = block_fits(model, translated(model, "pfc-linearpbond")).front();
  EXPECT_EQ(fit.misfit[3], std::numeric_limits<double>::infinity());
  expect_exact(model, translated(model, "edem-bonding-v2"));
}

// A bond without shear stiffness is nothing that edem-v2 takes; it still has an answer.
TEST(Translation, OfABondWithoutShearToEdemIsSound) {
  const Model model = unequal(block("contact", {{"kn", 7}, {"ks", 0}}));
  const auto there =
      bond_properties(as_realised(model, translated(model, "edem-bonding-v2"), Convention::both));
  EXPECT_NEAR(there[0].stiffness.kn, 7, 1e-14);
  EXPECT_EQ(there[0].stiffness.ks, 0);
  EXPECT_EQ(there[0].stiffness.kb, 0);
}

TEST(Translation, ToldByBlock) {
  Model model = unequal(block("timoshenko", beam));
  model.blocks.push_back(block("contact", {{"kn", 7}, {"ks", 5}}));
  model.bonds[1].block = 1;
  model.bonds[1].in_block = 0;
  const Translation translation = translated(model, "lammps-bpm-rotational");
  const auto fits = block_fits(model, translation);
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[0].bonds, 1);
  EXPECT_EQ(fits[1].lowest, std::vector<double>({7, 5, 0, 0}));
  EXPECT_EQ(fits[1].highest, fits[1].lowest);
  const auto there = bond_properties(as_realised(model, translation, Convention::both));
  for (std::size_t k = 0; k < 2; ++k) expect_equal(there[k], translation.realised[k]);
}

}  // namespace
}  // namespace bondstatic::test
