// C of each law against its formula, written with moduli and lengths alone.
#include <cmath>
#include <numbers>

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using std::numbers::pi;

constexpr double tight = 4e-15;  // a dozen roundings

void expect_stiffness(const SectionStiffness& c, double kn, double ks, double kt, double kb) {
  EXPECT_NEAR(c.kn, kn, tight * kn);
  EXPECT_NEAR(c.ks, ks, tight * ks);
  EXPECT_NEAR(c.kt, kt, tight * kt);
  EXPECT_NEAR(c.kb, kb, tight * kb);
  EXPECT_EQ(c.coupling, 0);
}

const double e = 70e9, nu = 0.23, r = 0.013, l = 0.071, g = e / (2 * (1 + nu));
const Inputs beam{{"young", e}, {"poisson", nu}, {"radius", r}};
const BondSite pair = site(l, 0.03, 0.04);

TEST(ParallelLaw, FollowsTable1WithGivenKappa) {
  const double kn = e * pi * r * r / l;
  expect_stiffness(evaluate("parallel", {{"young", e}, {"kappa", 3.1}, {"radius", r}}, pair).stiffness, kn,
                   kn / 3.1, 0.5 * kn / 3.1 * r * r, 0.25 * kn * r * r);
}

TEST(ParallelLaw, TakesKappaFromPoisson) {
  const double kn = e * pi * r * r / l, ks = g * pi * r * r / l;
  expect_stiffness(evaluate("parallel", beam, pair).stiffness, kn, ks, 0.5 * ks * r * r, 0.25 * kn * r * r);
}

TEST(ParallelLaw, TwistsAsTheBeamLawsWithKappaFromPoisson) {
  const double kt = evaluate("parallel", beam, pair).stiffness.kt;
  EXPECT_NEAR(evaluate("timoshenko", beam, pair).stiffness.kt, kt, tight * kt);
  EXPECT_NEAR(evaluate("euler-bernoulli", beam, pair).stiffness.kt, kt, tight * kt);
}

TEST(PfcParallelLaw, TakesStiffnessPerArea) {
  const Inputs inputs{{"normal_stiffness", 5e12}, {"shear_stiffness", 2e12}, {"radius", r}};
  expect_stiffness(evaluate("pfc-parallel", inputs, pair).stiffness, 5e12 * pi * r * r, 2e12 * pi * r * r,
                   2e12 * pi * std::pow(r, 4) / 2, 5e12 * pi * std::pow(r, 4) / 4);
}

TEST(PfcParallelLaw, DeformabilityDividesByTheSumOfTheRadii) {
  const Inputs inputs{{"effective_modulus", 3e9}, {"stiffness_ratio", 1.7}, {"radius", r}};
  const double kn = 3e9 / 0.07, ks = kn / 1.7;
  expect_stiffness(evaluate("pfc-parallel", inputs, pair).stiffness, kn * pi * r * r, ks * pi * r * r,
                   ks * pi * std::pow(r, 4) / 2, kn * pi * std::pow(r, 4) / 4);
}

TEST(EulerBernoulliLaw, FollowsTable9) {
  const double i = pi * std::pow(r, 4) / 4;
  expect_stiffness(evaluate("euler-bernoulli", beam, pair).stiffness, e * pi * r * r / l,
                   12 * e * i / (l * l * l), g * 2 * i / l, e * i / l);
}

TEST(TimoshenkoLaw, FollowsTable9) {
  const double i = pi * std::pow(r, 4) / 4, a = pi * r * r;
  // 1/ks: bending plus shear flexibility with form factor 10/9, which is what Phi of Eq. 25 stands for.
  const double ks = 1 / (l * l * l / (12 * e * i) + 10 * l / (9 * g * a));
  expect_stiffness(evaluate("timoshenko", beam, pair).stiffness, e * a / l, ks, g * 2 * i / l, e * i / l);
}

TEST(ObermayrLaw, TakesTheShearCoefficient) {
  const double i = pi * std::pow(r, 4) / 4, a = pi * r * r;
  expect_stiffness(evaluate("obermayr", beam, pair).stiffness, e * a / l, 0.9 * g * a / l, g * 2 * i / l,
                   e * i / l);
  Inputs other = beam;
  other["shear_coefficient"] = 0.75;
  expect_stiffness(evaluate("obermayr", other, pair).stiffness, e * a / l, 0.75 * g * a / l, g * 2 * i / l,
                   e * i / l);
}

TEST(EdemLaw, FollowsItsPage) {
  const Inputs inputs{
      {"normal_stiffness", 5e12}, {"shear_stiffness", 2e12}, {"disk_scale", 0.5}, {"torque_feedback", 1}};
  const BondProperties p = evaluate("edem-v2", inputs, pair);
  const double s = 0.5 * 0.03, j = pi * std::pow(s, 4) / 2;
  EXPECT_EQ(p.radius, s);
  EXPECT_TRUE(p.moments_fed_back);
  expect_stiffness(p.stiffness, 5e12 * pi * s * s, 2e12 * pi * s * s, 2e12 * j, 5e12 * j / 2);
}

TEST(EdemLaw, KeepsItsMomentsWithoutTorqueFeedback) {
  Inputs inputs{{"normal_stiffness", 5e12}, {"shear_stiffness", 2e12}, {"torque_feedback", 0}};
  const BondProperties off = evaluate("edem-v2", inputs, pair);
  inputs["torque_feedback"] = 1;
  const BondProperties on = evaluate("edem-v2", inputs, pair);
  EXPECT_FALSE(off.moments_fed_back);
  EXPECT_EQ(off.stiffness.kt, on.stiffness.kt);
  EXPECT_EQ(off.stiffness.kb, on.stiffness.kb);
}

TEST(ContactLaw, CarriesNoMoment) {
  const BondProperties p = evaluate("contact", {{"kn", 3e6}, {"ks", 0}}, pair);
  EXPECT_EQ(p.stiffness.kn, 3e6);
  EXPECT_EQ(p.stiffness.ks, 0);
  EXPECT_EQ(p.stiffness.kt, 0);
  EXPECT_EQ(p.stiffness.kb, 0);
  EXPECT_TRUE(std::isnan(p.radius));
  EXPECT_EQ(evaluate("contact", {{"kn", 3e6}, {"ks", 0}, {"radius", 0.1}}, pair).radius, 0.1);
}

TEST(GenericLaw, TakesWhatIsGiven) {
  const BondProperties p = evaluate("generic", {{"kn", 1}, {"ks", 2}, {"kt", 3}, {"kb", 4}}, pair);
  expect_stiffness(p.stiffness, 1, 2, 3, 4);
  EXPECT_TRUE(std::isnan(p.radius));
}

TEST(BondRadius, IsGivenOrAFactorTimesTheSmallerParticle) {
  Inputs inputs{{"young", e}, {"poisson", nu}};
  EXPECT_EQ(evaluate("timoshenko", inputs, pair).radius, 0.03);
  inputs["radius_factor"] = 0.8;
  EXPECT_EQ(evaluate("timoshenko", inputs, pair).radius, 0.8 * 0.03);
  EXPECT_EQ(evaluate("timoshenko", beam, pair).radius, r);
}

TEST(StiffnessRatio, IsTheExactFractionOfTheSlenderness) {
  for (const double slenderness : {0.5, 1.0, 3.0, 10.0}) {
    const BondSite here = site(2 * r * slenderness, 0.03, 0.04);
    const SectionStiffness eb = evaluate("euler-bernoulli", beam, here).stiffness;
    const SectionStiffness tb = evaluate("timoshenko", beam, here).stiffness;
    const double ratio = 4.0 / 3 * slenderness * slenderness, shear = 20.0 / 9 * (1 + nu);
    EXPECT_NEAR(eb.kn / eb.ks, ratio, tight * ratio);
    EXPECT_NEAR(tb.kn / tb.ks, ratio + shear, tight * (ratio + shear));
  }
}

// [Chen2022] Table 5, in GPa m: case 3, L0 = 4, r = 0.2, E = 200 GPa, nu = 0.3. The paper rounds some entries
// and truncates others, so each may be off by less than one unit of its last digit.
TEST(ChenTable5, IsReachedToThePrintedDigits) {
  struct Row {
    int bonds;
    double axial, axial_unit, parallel, parallel_unit, euler, euler_unit, timoshenko, timoshenko_unit;
  };
  const Row rows[] = {{1, 6.283, 1e-3, 2.416, 1e-3, 0.04712, 1e-5, 0.04612, 1e-5},
                      {2, 12.56, 1e-2, 4.833, 1e-3, 0.3769, 1e-4, 0.3469, 1e-4},
                      {4, 25.13, 1e-2, 9.66, 1e-2, 3.016, 1e-3, 2.240, 1e-3},
                      {6, 37.69, 1e-2, 14.50, 1e-2, 10.18, 1e-2, 5.718, 1e-3},
                      {8, 50.26, 1e-2, 19.33, 1e-2, 24.13, 1e-2, 10.11, 1e-2},
                      {10, 62.83, 1e-2, 24.17, 1e-2, 47.12, 1e-2, 14.88, 1e-2}};
  const Inputs inputs{{"young", 200}, {"poisson", 0.3}, {"radius", 0.2}};  // GPa
  for (const Row& row : rows) {
    const BondSite here = site(4.0 / row.bonds, 0.2, 0.2);
    SCOPED_TRACE(row.bonds);
    EXPECT_NEAR(evaluate("timoshenko", inputs, here).stiffness.kn, row.axial, row.axial_unit);
    EXPECT_NEAR(evaluate("parallel", inputs, here).stiffness.ks, row.parallel, row.parallel_unit);
    EXPECT_NEAR(evaluate("euler-bernoulli", inputs, here).stiffness.ks, row.euler, row.euler_unit);
    EXPECT_NEAR(evaluate("timoshenko", inputs, here).stiffness.ks, row.timoshenko, row.timoshenko_unit);
  }
}

TEST(LawCatalogue, ListsTheTenLawsWithAllThatAListingNeeds) {
  std::vector<std::string> names;
  for (const BondLaw& law : bond_laws()) {
    names.push_back(law.name);
    EXPECT_EQ(find_bond_law(law.name), &law);
    EXPECT_FALSE(law.title.empty() || law.source.empty() || law.remark.empty() || law.formulas.empty())
        << law.name;
    EXPECT_NE(law.contact_point.kind, ContactPoint::Kind::of_law);
    EXPECT_TRUE(law.evaluate);
    for (const Parameter& parameter : law.parameters)
      EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
    for (const Alternatives& alternative : law.alternatives)
      for (const auto& way : alternative)
        for (const std::string& parameter : way) EXPECT_GE(law.find(parameter), 0) << parameter;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"parallel", "pfc-parallel", "euler-bernoulli", "timoshenko", "obermayr",
                                      "edem-v2", "contact", "two-segment", "concave-end", "generic"}));
  EXPECT_EQ(find_bond_law("hertz"), nullptr);
}

// Four times every modulus is four times C, bitwise.
TEST(EveryLaw, IsLinearInItsModuli) {
  RandomBonds random;
  for (const auto& [name, inputs] : typical_inputs()) {
    const BondSite here = random.gapped_site();
    Inputs stiffer = inputs;
    const BondLaw& law = *find_bond_law(name);
    for (auto& [parameter, value] : stiffer)
      if (law.parameters[std::size_t(law.find(parameter))].dimension.mass == 1) value *= 4;
    const SectionStiffness soft = evaluate(name, inputs, here).stiffness;
    const SectionStiffness stiff = evaluate(name, stiffer, here).stiffness;
    EXPECT_EQ(stiff.kn, 4 * soft.kn) << name;
    EXPECT_EQ(stiff.ks, 4 * soft.ks) << name;
    EXPECT_EQ(stiff.kt, 4 * soft.kt) << name;
    EXPECT_EQ(stiff.kb, 4 * soft.kb) << name;
    EXPECT_EQ(stiff.coupling, 4 * soft.coupling) << name;
  }
}

}  // namespace
}  // namespace bondstatic
