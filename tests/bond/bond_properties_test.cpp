// All bonds of a model: blocks, overrides of single bonds, and what is refused.
#include "bond/bond_fixture.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

using testing::HasSubstr;

/// Particles 10, 20, 30 ... of radius 0.1, 0.25 apart, each bonded to the next by block 0.
Model chain(const std::string& law, const Inputs& inputs, std::size_t bonds = 3) {
  Model model;
  for (std::size_t k = 0; k <= bonds; ++k)
    model.particles.push_back(
        {.id = Index(10 * (k + 1)), .position = {0.25 * double(k), 0, 0}, .radius = 0.1});
  model.blocks = {{.law = law, .parameters = {}, .contact_point = {}, .overrides = {}}};
  if (const BondLaw* known = find_bond_law(law)) model.blocks[0].parameters = in_order(*known, inputs);
  for (std::size_t k = 0; k < bonds; ++k)
    model.bonds.push_back({.id = Index(k + 1),
                           .a = Index(k),
                           .b = Index(k + 1),
                           .branch = {0.25, 0, 0},
                           .block = 0,
                           .in_block = Index(k)});
  return model;
}

const Inputs beam{{"young", 1e9}, {"poisson", 0.25}};

std::vector<Fault> faults(const Model& model) {
  try {
    bond_properties(model);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

TEST(BondProperties, AreTheLawsAtEveryBond) {
  Model model = chain("timoshenko", beam);
  model.particles[1].radius = 0.05;
  const auto found = bond_properties(model);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].radius, 0.05);
  EXPECT_EQ(found[2].radius, 0.1);
  EXPECT_EQ(found[2].stiffness.ks, evaluate("timoshenko", beam, site(0.25, 0.1, 0.1)).stiffness.ks);
  EXPECT_EQ(found[0].fraction, 0.5);
}

TEST(BondProperties, UseTheBlocksContactPoint) {
  Model model = chain("timoshenko", beam, 1);
  model.particles[0].radius = 0.12;
  model.blocks[0].contact_point = {ContactPoint::Kind::gap, 0};
  EXPECT_NEAR(bond_properties(model)[0].fraction, 0.5 * (0.25 + 0.02) / 0.25, 1e-15);
}

TEST(BondProperties, LetABondsOwnContactPointBeatItsBlocks) {
  Model model = chain("timoshenko", beam);
  model.blocks[0].contact_point = {ContactPoint::Kind::fraction, 0.25};
  model.blocks[0].fractions = {0.75, not_given, 0.5};
  const auto found = bond_properties(model);
  EXPECT_EQ(found[0].fraction, 0.75);
  EXPECT_EQ(found[1].fraction, 0.25);
  EXPECT_EQ(found[2].fraction, 0.5);
}

TEST(BondProperties, MoveTheStiffnessOfASteppedSectionToABondsOwnContactPoint) {
  Model model = chain("two-segment", beam, 2);
  model.particles[1].radius = 0.05;
  Model moved = model;
  moved.blocks[0].contact_point = {ContactPoint::Kind::fraction, 0.3};
  model.blocks[0].fractions = {0.3, not_given};
  const auto own = bond_properties(model), block = bond_properties(moved);
  EXPECT_EQ(own[0].stiffness.coupling, block[0].stiffness.coupling);
  EXPECT_EQ(own[0].stiffness.kb, block[0].stiffness.kb);
  EXPECT_NE(own[1].fraction, block[1].fraction);
}

TEST(BondProperties, FollowTheBlockOfEachBond) {
  Model model = chain("timoshenko", beam);
  model.blocks.push_back({.law = "contact", .parameters = {7, 3}, .contact_point = {}, .overrides = {}});
  model.bonds[1].block = 1;
  const auto found = bond_properties(model);
  EXPECT_EQ(found[1].stiffness.kn, 7);
  EXPECT_EQ(found[1].stiffness.kb, 0);
  EXPECT_GT(found[2].stiffness.kb, 0);
}

TEST(BondProperties, LetABondsOwnValueBeatItsBlocks) {
  Model model = chain("timoshenko", {{"young", 1e9}, {"poisson", 0.25}, {"radius_factor", 0.5}});
  model.blocks[0].overrides = {{0, {not_given, 2e9, not_given}}, {2, {0.08, not_given, not_given}}};
  const auto found = bond_properties(model);
  EXPECT_EQ(found[0].radius, 0.08);
  EXPECT_EQ(found[1].radius, 0.05);
  EXPECT_EQ(found[2].radius, 0.05);
  EXPECT_EQ(found[1].stiffness.kn, 2 * found[2].stiffness.kn);
}

TEST(BondProperties, AcceptAParameterThatOnlyTheBondsGive) {
  Model model = chain("timoshenko", {{"poisson", 0.25}});
  model.blocks[0].overrides = {{0, {1e9, 2e9, 4e9}}};
  const auto found = bond_properties(model);
  EXPECT_EQ(found[2].stiffness.kn, 4 * found[0].stiffness.kn);
  model.blocks[0].overrides = {{0, {1e9, not_given, 4e9}}};
  const auto refused = faults(model);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_THAT(refused[0].message,
              HasSubstr("bond 2 between particles 20 and 30 (law timoshenko): young missing"));
}

TEST(BondProperties, CheckTheBoundsOfABondsOwnValues) {
  Model model = chain("timoshenko", beam);
  model.blocks[0].overrides = {{1, {0.7, not_given, -2}}};
  const auto refused = faults(model);
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_THAT(refused[0].message,
              HasSubstr("bond 1 between particles 10 and 20 (law timoshenko): poisson = 0.7: must"));
  EXPECT_THAT(refused[1].message,
              HasSubstr("bond 3 between particles 30 and 40 (law timoshenko): poisson = -2: must"));
}

TEST(BondProperties, RefuseABondWithoutLength) {
  Model model = chain("timoshenko", beam);
  model.bonds[1].branch.setZero();
  const auto refused = faults(model);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0].message,
            "bond 2 between particles 20 and 30 (law timoshenko): length = 0 must be positive");
  EXPECT_EQ(refused[0].cure, "move the particles apart, or remove the bond");
  EXPECT_EQ(refused[0].place.line, 0);
}

TEST(BondProperties, RefuseWhatALawForbidsNamingTheBond) {
  Model model = chain("concave-end", beam);
  model.bonds[2].branch = {0.15, 0, 0};
  const auto refused = faults(model);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_THAT(refused[0].message,
              testing::AllOf(HasSubstr("bond 3 between particles 30 and 40"), HasSubstr("gap = -0.05")));
  EXPECT_THAT(refused[0].cure, HasSubstr("another law"));
}

TEST(BondProperties, RefuseAStiffnessOutOfTheRangeOfDoubles) {
  EXPECT_EQ(faults(chain("timoshenko", {{"young", 1e308}, {"poisson", 0.25}, {"radius", 1e3}}, 1)).size(),
            1u);
  EXPECT_EQ(faults(chain("timoshenko", {{"young", 1e9}, {"poisson", 0.25}, {"radius", 1e-170}}, 1)).size(),
            1u);
}

TEST(BondProperties, ListKnownLawsForAnUnknownOne) {
  const auto refused = faults(chain("hertz", {}));
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0].message, "bonds.0 (law hertz): unknown law");
  EXPECT_THAT(refused[0].cure, testing::AllOf(HasSubstr("timoshenko"), HasSubstr("two-segment")));
}

TEST(BondProperties, SayAllFaultsOfABlockAtOnceAndOnce) {
  const auto refused = faults(chain("timoshenko", {{"young", -1}, {"poisson", 2}}, 5));
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_THAT(refused[0].message, HasSubstr("young = -1"));
  EXPECT_THAT(refused[1].message, HasSubstr("poisson = 2"));
}

TEST(BondProperties, CountFaultsBeyondTheFirstOnes) {
  Model model = chain("timoshenko", beam, 100);
  for (Bond& bond : model.bonds) bond.branch.setZero();
  const auto refused = faults(model);
  ASSERT_EQ(refused.size(), 21u);
  EXPECT_THAT(refused.back().message, HasSubstr("80 more"));
}

}  // namespace
}  // namespace bondstatic
