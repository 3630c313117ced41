// Other codes' bonds: the table says all that it must, and numbers come back through it.
#include "bond/codes.hpp"

#include "bond/bond_fixture.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {
namespace {

struct ACode : testing::TestWithParam<std::string> {
  const BondCode& code = *find_bond_code(GetParam());
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const BondCode& code : bond_codes()) all.push_back(code.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, ACode, testing::ValuesIn(names()), [](const auto& name) {
  std::string id = name.param;
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
});

TEST_P(ACode, SaysEverything) {
  for (const std::string& said :
       {code.name, code.title, code.version, code.contact_point_text, code.known_from, code.shear,
        code.moments, code.here, code.fit, code.source})
    EXPECT_FALSE(said.empty());
  EXPECT_FALSE(code.remarks.empty());
  EXPECT_NE(code.contact_point.kind, ContactPoint::Kind::of_law);
  EXPECT_EQ(bool(code.departure), !code.departure_text.empty());
  ASSERT_GE(code.stored.size(), 3u);
  for (const CodeParameter& parameter : code.stored) {
    EXPECT_FALSE(parameter.name.empty());
    EXPECT_FALSE(parameter.meaning.empty());
    EXPECT_FALSE(parameter.input.empty());
  }
  std::string formulas;
  for (const std::string& formula : code.formulas) formulas += formula + "; ";
  for (const char* stiffness : {"kn = ", "ks = ", "kt = ", "kb = "})
    EXPECT_THAT(formulas, testing::HasSubstr(stiffness));
}

/// Stored numbers of the size that their units have for particles of 0.1 to 0.2.
std::vector<double> random_numbers(const BondCode& code, RandomBonds& random) {
  std::vector<double> numbers;
  for (const CodeParameter& parameter : code.stored) {
    if (parameter.truth)
      numbers.push_back(random.uniform(0, 1) < 0.5);
    else if (parameter.dimension == dimension::none)
      numbers.push_back(random.uniform(0.1, 0.5));
    else if (parameter.dimension == dimension::length)
      numbers.push_back(random.uniform(0.05, 0.3));
    else
      numbers.push_back(random.uniform(1e4, 1e10));
  }
  return numbers;
}

// A number passes through nine roundings at most.
TEST_P(ACode, GivesAThousandRandomBondsTheirNumbersBack) {
  RandomBonds random;
  for (int i = 0; i < 1000; ++i) {
    const BondSite here = random.gapped_site();
    std::vector<double> numbers = random_numbers(code, random);
    const std::vector<double> back = code.stored_for(here, code.realised(here, numbers));
    ASSERT_EQ(back.size(), numbers.size());
    for (std::size_t p = 0; p < numbers.size(); ++p) {
      // Poisson's ratio is E/2G - 1: rounding is that of the quotient.
      const double size = code.stored[p].name == "poisson" ? 1 + numbers[p] : std::abs(numbers[p]);
      EXPECT_NEAR(back[p], numbers[p], 1e-15 * size) << code.stored[p].name;
    }
  }
}

TEST_P(ACode, MeetsNormalAndShearStiffnessOfEveryLaw) {
  for (const auto& [law, inputs] : typical_inputs()) {
    RandomBonds random;
    for (int i = 0; i < 50; ++i) {
      const BondSite here = random.gapped_site();
      BondProperties wanted = evaluate(law, inputs, here);
      wanted.stiffness.coupling = 0;
      const BondProperties real = code.realised(here, code.stored_for(here, wanted));
      EXPECT_NEAR(real.stiffness.kn, wanted.stiffness.kn, 1e-14 * wanted.stiffness.kn) << law;
      EXPECT_NEAR(real.stiffness.ks, wanted.stiffness.ks, 1e-14 * wanted.stiffness.ks) << law;
      if (real.moments_fed_back && wanted.stiffness.kb > 0) {
        EXPECT_NEAR(real.stiffness.kb, wanted.stiffness.kb, 1e-14 * wanted.stiffness.kb) << law;
      }
    }
  }
}

TEST(Codes, ThatStoreFourStiffnessesMeetThemAll) {
  const BondSite here = site(0.5, 0.2, 0.15);
  BondProperties wanted;
  wanted.stiffness = {.kn = 7, .ks = 5, .kt = 3, .kb = 2};
  for (const char* name : {"lammps-bpm-rotational", "yade-cohfrict"}) {
    const BondCode& code = *find_bond_code(name);
    const SectionStiffness c = code.realised(here, code.stored_for(here, wanted)).stiffness;
    EXPECT_EQ(c.kn, 7);
    EXPECT_NEAR(c.ks, 5, 1e-15);
    EXPECT_EQ(c.kt, 3);
    EXPECT_EQ(c.kb, 2);
  }
}

TEST(Codes, ThatTieMomentsToForcesGetTwistingWrongOfABeam) {
  const BondSite here = site(0.5, 0.2, 0.15);
  const BondProperties beam =
      evaluate("timoshenko", {{"young", 1e9}, {"poisson", 0.25}, {"radius", 0.1}}, here);
  for (const char* name : {"pfc-linearpbond", "edem-bonding-v2", "musen-solid-bond"}) {
    const BondCode& code = *find_bond_code(name);
    const BondProperties real = code.realised(here, code.stored_for(here, beam));
    EXPECT_NEAR(real.radius, 0.1, 1e-15) << name;
    EXPECT_NEAR(real.stiffness.kt, 0.5 * beam.stiffness.ks * 0.01, 1e-14 * real.stiffness.kt) << name;
    EXPECT_GT(std::abs(real.stiffness.kt / beam.stiffness.kt - 1), 0.01) << name;
  }
}

TEST(Codes, PfcAndEdemAreTheLawsOfThatName) {
  const BondSite here = site(0.5, 0.2, 0.15);
  const std::vector<double> pfc{3e9, 1e9, 0.8};
  const BondProperties law = evaluate(
      "pfc-parallel", {{"normal_stiffness", 3e9}, {"shear_stiffness", 1e9}, {"radius_factor", 0.8}}, here);
  const BondProperties code = find_bond_code("pfc-linearpbond")->realised(here, pfc);
  EXPECT_EQ(code.stiffness.kn, law.stiffness.kn);
  EXPECT_EQ(code.stiffness.kt, law.stiffness.kt);
  EXPECT_EQ(code.stiffness.kb, law.stiffness.kb);
  const std::vector<double> edem{3e9, 1e9, 0.8, 0};
  const BondProperties off = find_bond_code("edem-bonding-v2")->realised(here, edem);
  EXPECT_FALSE(off.moments_fed_back);
  EXPECT_NEAR(off.stiffness.kb, law.stiffness.kb, 1e-15 * law.stiffness.kb);
}

TEST(Codes, MusenIsObermayrsBeamWithoutShearReduction) {
  const BondSite here = site(0.5, 0.2, 0.15);
  const std::vector<double> numbers{0.2, 1e9, 0.25};
  const SectionStiffness code = find_bond_code("musen-solid-bond")->realised(here, numbers).stiffness;
  const SectionStiffness law =
      evaluate("obermayr", {{"young", 1e9}, {"poisson", 0.25}, {"radius", 0.1}, {"shear_coefficient", 1}},
               here)
          .stiffness;
  EXPECT_NEAR(code.kn, law.kn, 1e-15 * law.kn);
  EXPECT_NEAR(code.ks, law.ks, 1e-15 * law.ks);
  EXPECT_NEAR(code.kt, law.kt, 1e-15 * law.kt);
  EXPECT_NEAR(code.kb, law.kb, 1e-15 * law.kb);
}

TEST(Codes, LiggghtsTakesHalfTheRelativeRotationOfTouchingParticles) {
  const BondSite touching = site(0.4, 0.2, 0.2);
  const BondCode& code = *find_bond_code("liggghts-bond-gran");
  const std::vector<double> numbers{0.5, 3e9, 1e9};
  const RoundSection section{0.1};
  const BondProperties real = code.realised(touching, numbers);
  EXPECT_NEAR(real.stiffness.kb, 0.5 * 3e9 * section.second_moment(), 1e-9);
  EXPECT_NEAR(real.stiffness.kt, 0.5 * 1e9 * section.polar_moment(), 1e-9);
  EXPECT_EQ(code.departure(touching), 0);
  EXPECT_NEAR(code.departure(site(0.5, 0.2, 0.2)), 0.2, 1e-16);
  EXPECT_NEAR(code.departure(site(0.4, 0.3, 0.1)), 0.25, 1e-16);
}

// Two spheres probed in YADE 2023.02a, young 1e6, poisson 0.4, alphaKr 0.3, alphaKtw 0.2: body 1 moved by
// 1e-6 across the bond, and turned by it.
TEST(Codes, YadeIsAsItsProbeFoundIt) {
  const BondCode& code = *find_bond_code("yade-cohfrict");
  struct Probe {
    BondSite site;
    std::vector<double> stored;
    double moved, turned_force, turned_moment;  ///< shear force, and torque on body 0 when body 0 was turned
  };
  const std::vector<double> equal{1e6, 4e5, 8e4, 1.2e5}, unequal{1e6 * 2 / 3, 4e5 * 2 / 3, 8e4 / 3, 4e4};
  for (const Probe& probe : {Probe{site(2, 1, 1), equal, 0.4, 0.4, 0.52},
                             {site(2.5, 1, 1), equal, 0.32, 0.4, 0.62},
                             {site(1.5, 1, 0.5), unequal, 4.0 / 15, 4.0 / 15, 0.92 / 3}}) {
    const BondProperties real = code.realised(probe.site, probe.stored);
    EXPECT_EQ(code.departure(probe.site), 0);
    const double lever =
        contact_fraction(code.contact_point, bond_laws().front(), probe.site) * probe.site.length;
    EXPECT_NEAR(1e-6 * real.stiffness.ks, probe.moved, 1e-12);
    EXPECT_NEAR(1e-6 * real.stiffness.ks * lever, probe.turned_force, 1e-12);
    EXPECT_NEAR(1e-6 * (real.stiffness.ks * lever * lever + real.stiffness.kb), probe.turned_moment, 1e-12);
  }
  // Unequal with a gap: force 0.2667 at lever 1.2, displacement at lever 1.9 * 2/3.
  EXPECT_NEAR(code.departure(site(1.9, 1, 0.5)), (1.9 * 2 / 3 - 1.2) / 1.9, 1e-15);
}

TEST(Codes, BondsWithoutMomentsAskForTheirOwnSection) {
  const BondSite here = site(0.5, 0.2, 0.15);
  BondProperties point;
  point.stiffness = {.kn = 7, .ks = 5};
  for (const char* name : {"pfc-linearpbond", "liggghts-bond-gran", "edem-bonding-v2", "musen-solid-bond"}) {
    const BondCode& code = *find_bond_code(name);
    EXPECT_NEAR(code.realised(here, code.stored_for(here, point)).radius, 0.15, 1e-16) << name;
    BondProperties own = point;
    own.radius = 0.05;
    EXPECT_NEAR(code.realised(here, code.stored_for(here, own)).radius, 0.05, 1e-16) << name;
  }
  EXPECT_FALSE(find_bond_code("edem-bonding-v2")
                   ->realised(here, find_bond_code("edem-bonding-v2")->stored_for(here, point))
                   .moments_fed_back);
}

TEST(Codes, UnknownNamesAreNotFound) {
  EXPECT_EQ(find_bond_code("pfc"), nullptr);
  EXPECT_EQ(bond_codes().size(), 6u);
}

}  // namespace
}  // namespace bondstatic
