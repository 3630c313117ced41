// Derivatives of the laws against differences of what they say, and against closed forms.
#include <algorithm>
#include <array>

#include "bond/bond_fixture.hpp"
#include "support/ridders.hpp"

namespace bondstatic {
namespace {

constexpr std::array<const char*, 6> entries{"kn", "ks", "kt", "kb", "coupling", "radius"};

std::array<double, 6> numbers(const SectionStiffness& c, double radius) {
  return {c.kn, c.ks, c.kt, c.kb, c.coupling, radius};
}
std::array<double, 6> numbers(const BondProperties& p) {
  return numbers(p.stiffness, p.radius);
}
std::array<double, 6> numbers(const BondDerivative& d) {
  return numbers(d.stiffness, d.radius);
}

/// Every way to say each law, all parameters of it given.
std::vector<std::pair<std::string, Inputs>> every_way() {
  std::vector<std::pair<std::string, Inputs>> out;
  for (const auto& [name, value] : {std::pair("radius", 0.08), std::pair("radius_factor", 0.7)}) {
    const Inputs beam{{"young", 7e10}, {"poisson", 0.2}, {name, value}};
    for (const char* law : {"parallel", "euler-bernoulli", "timoshenko", "concave-end"})
      out.emplace_back(law, beam);
    out.emplace_back("obermayr", beam);
    out.back().second["shear_coefficient"] = 0.85;
    out.push_back({"parallel", {{"young", 7e10}, {"kappa", 2.5}, {name, value}}});
    out.push_back({"pfc-parallel", {{"normal_stiffness", 3e10}, {"shear_stiffness", 1e10}, {name, value}}});
    out.push_back({"pfc-parallel", {{"effective_modulus", 3e9}, {"stiffness_ratio", 1.5}, {name, value}}});
  }
  for (const double feedback : {0, 1})
    out.push_back({"edem-v2",
                   {{"normal_stiffness", 1e10},
                    {"shear_stiffness", 4e9},
                    {"disk_scale", 0.9},
                    {"normal_range", 3e9},
                    {"shear_range", 1e9},
                    {"seed", 7},
                    {"torque_feedback", feedback}}});
  out.push_back({"two-segment", {{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.6}}});
  out.push_back({"contact", {{"kn", 1e8}, {"ks", 3e7}, {"radius", 0.05}}});
  out.push_back({"generic", {{"kn", 1e8}, {"ks", 3e7}, {"kt", 2e5}, {"kb", 4e5}, {"radius", 0.05}}});
  return out;
}

bool is_number(const Parameter& parameter) {
  return !parameter.whole && !parameter.truth;
}

/// Calls `check` for every number among the inputs of every way, at random sites of unequal particles.
template <class Check>
void for_every_parameter(Check check) {
  RandomBonds random;
  for (const auto& [name, inputs] : every_way())
    for (int k = 0; k < 20; ++k) {
      const BondLaw& law = *find_bond_law(name);
      BondSite here = random.gapped_site();
      here.id_a = 1 + k;
      here.id_b = 100 - k;
      std::vector<double> values = in_order(law, inputs);
      for (std::size_t p = 0; p < values.size(); ++p)
        if (is_number(law.parameters[p])) values[p] *= random.uniform(0.8, 1.2);
      for (std::size_t p = 0; p < values.size(); ++p) {
        if (std::isnan(values[p]) || !is_number(law.parameters[p])) continue;
        SCOPED_TRACE(name + " by " + law.parameters[p].name);
        check(law, here, values, p);
      }
    }
}

TEST(LawDerivatives, AreThereForEveryLaw) {
  for (const BondLaw& law : bond_laws()) {
    EXPECT_TRUE(law.differentiate) << law.name;
    for (std::size_t p = 0; p < law.parameters.size(); ++p) {
      if (!is_number(law.parameters[p])) continue;
      const auto ways = every_way();
      EXPECT_TRUE(std::any_of(
          ways.begin(), ways.end(),
          [&](const auto& way) { return way.first == law.name && way.second.count(law.parameters[p].name); }))
          << "no test of " << law.name << " by " << law.parameters[p].name;
    }
  }
}

TEST(LawDerivatives, EqualExtrapolatedDifferences) {
  double worst = 0;
  for_every_parameter(
      [&](const BondLaw& law, const BondSite& here, std::vector<double> values, std::size_t p) {
        const auto exact = numbers(law.differentiate(here, values, p));
        const auto value = numbers(law.evaluate(here, values));
        const double x = values[p];
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const test::Difference found = test::ridders(
              [&](double changed) {
                values[p] = changed;
                return numbers(law.evaluate(here, values))[i];
              },
              x, 0.1 * x);
          const double size = std::max(std::abs(exact[i]), 1e-3 * std::abs(value[i] / x));
          EXPECT_LE(std::abs(exact[i] - found.value), 1e-10 * size) << entries[i];
          if (size > 0) worst = std::max(worst, std::abs(exact[i] - found.value) / size);
        }
      });
  RecordProperty("worst", testing::PrintToString(worst));
}

/// The exponents of a parameter where each number is a power of it.
struct Power {
  const char* law;
  const char* parameter;
  std::array<double, 6> exponent;
};

TEST(LawDerivatives, OfPowersAreTheExponentTimesValueOverParameter) {
  const std::array<double, 6> all{1, 1, 1, 1, 1, 0}, radius{2, 2, 4, 4, 0, 1};
  const std::vector<Power> powers{
      {"parallel", "young", all},
      {"parallel", "kappa", {0, -1, -1, 0, 0, 0}},
      {"parallel", "radius", radius},
      {"parallel", "radius_factor", radius},
      {"pfc-parallel", "normal_stiffness", {1, 0, 0, 1, 0, 0}},
      {"pfc-parallel", "shear_stiffness", {0, 1, 1, 0, 0, 0}},
      {"pfc-parallel", "effective_modulus", all},
      {"pfc-parallel", "stiffness_ratio", {0, -1, -1, 0, 0, 0}},
      {"pfc-parallel", "radius", radius},
      {"pfc-parallel", "radius_factor", radius},
      {"euler-bernoulli", "young", all},
      {"euler-bernoulli", "radius", {2, 4, 4, 4, 0, 1}},
      {"euler-bernoulli", "radius_factor", {2, 4, 4, 4, 0, 1}},
      {"timoshenko", "young", all},
      {"obermayr", "young", all},
      {"obermayr", "shear_coefficient", {0, 1, 0, 0, 0, 0}},
      {"obermayr", "radius", radius},
      {"edem-v2", "disk_scale", radius},
      {"contact", "kn", {1, 0, 0, 0, 0, 0}},
      {"contact", "ks", {0, 1, 0, 0, 0, 0}},
      {"contact", "radius", {0, 0, 0, 0, 0, 1}},
      {"two-segment", "young", all},
      {"concave-end", "young", all},
      {"generic", "kn", {1, 0, 0, 0, 0, 0}},
      {"generic", "ks", {0, 1, 0, 0, 0, 0}},
      {"generic", "kt", {0, 0, 1, 0, 0, 0}},
      {"generic", "kb", {0, 0, 0, 1, 0, 0}},
      {"generic", "radius", {0, 0, 0, 0, 0, 1}},
  };
  std::size_t checked = 0;
  for_every_parameter([&](const BondLaw& law, const BondSite& here, const std::vector<double>& values,
                          std::size_t p) {
    for (const Power& power : powers) {
      if (power.law != law.name || power.parameter != law.parameters[p].name) continue;
      const auto exact = numbers(law.differentiate(here, values, p));
      const auto value = numbers(law.evaluate(here, values));
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const double closed = power.exponent[i] == 0 ? 0 : power.exponent[i] * value[i] / values[p];
        // The coupling is a difference: its size is that of what it may be at most.
        const double size = i == 4 ? std::sqrt(value[1]) * std::sqrt(value[3]) / values[p] : std::abs(closed);
        EXPECT_LE(std::abs(exact[i] - closed), 1e-15 * size) << entries[i];
      }
      ++checked;
    }
  });
  EXPECT_GE(checked, 20 * powers.size());
}

TEST(LawDerivatives, OfPoissonsRatioAreTheShearModulus) {
  // G ~ 1 / (1 + nu)
  struct Case {
    const char* law;
    std::array<bool, 6> by_shear_modulus;
  };
  for (const Case& each :
       {Case{"parallel", {false, true, true}}, Case{"euler-bernoulli", {false, false, true}},
        Case{"obermayr", {false, true, true}}, Case{"concave-end", {false, true, true}}}) {
    const BondLaw& law = *find_bond_law(each.law);
    const std::vector<double> values =
        in_order(law, {{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.7}});
    std::vector<std::string> found;
    const std::vector<double> complete = complete_parameters(law, values, found);
    const BondSite here = site(0.4, 0.11, 0.17);
    const auto exact = numbers(law.differentiate(here, complete, std::size_t(law.find("poisson"))));
    const auto value = numbers(law.evaluate(here, complete));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double closed = each.by_shear_modulus[i] ? -value[i] / 1.2 : 0;
      EXPECT_LE(std::abs(exact[i] - closed), 1e-15 * std::abs(closed)) << each.law << " " << entries[i];
    }
  }
}

TEST(LawDerivatives, OfTimoshenkosShearStiffnessFollowFromPhi) {
  // ks = 12 E I / (L^3 (1 + Phi)), Phi = c r^2 (1 + nu)
  const BondLaw& law = *find_bond_law("timoshenko");
  const std::vector<double> values = in_order(law, {{"young", 7e10}, {"poisson", 0.2}, {"radius", 0.1}});
  const BondSite here = site(0.4, 0.11, 0.17);
  const double phi = 20 * 0.1 * 0.1 * 1.2 / (3 * 0.4 * 0.4), ks = law.evaluate(here, values).stiffness.ks;
  const double by_poisson = -ks * phi / (1.2 * (1 + phi)), by_radius = ks / 0.1 * (4 - 2 * phi / (1 + phi));
  EXPECT_NEAR(law.differentiate(here, values, 1).stiffness.ks / by_poisson, 1, 1e-15);
  EXPECT_NEAR(law.differentiate(here, values, 2).stiffness.ks / by_radius, 1, 1e-15);
}

TEST(LawDerivatives, OfScatteredStiffnessAreTheDraw) {
  const BondLaw& law = *find_bond_law("edem-v2");
  const BondSite here{0.4, 0.1, 0.2, 5, 9};
  const std::vector<double> values{1e10, 4e9, 1, 3e9, 1e9, 7, 0};
  std::vector<double> without = values;
  without[3] = without[4] = 0;
  const SectionStiffness c = law.evaluate(here, values).stiffness;
  const SectionStiffness mean = law.evaluate(here, without).stiffness;
  // (Sn drawn - Sn) / range and the mean's area, each to the rounding of the difference.
  const SectionStiffness by_range = law.differentiate(here, values, 3).stiffness;
  EXPECT_NEAR(by_range.kn, (c.kn - mean.kn) / 3e9, 1e-15 * c.kn / 3e9);
  EXPECT_NEAR(by_range.kb, (c.kb - mean.kb) / 3e9, 1e-15 * c.kb / 3e9);
  EXPECT_NE(by_range.kn, 0);
  EXPECT_EQ(by_range.ks, 0);
  const SectionStiffness by_shear_range = law.differentiate(here, values, 4).stiffness;
  EXPECT_NEAR(by_shear_range.kt, (c.kt - mean.kt) / 1e9, 1e-15 * c.kt / 1e9);
  const SectionStiffness by_mean = law.differentiate(here, values, 0).stiffness;
  EXPECT_NEAR(by_mean.kn, mean.kn / 1e10, 1e-15 * mean.kn / 1e10);
  // Whether its moments act on the particles does not change what the bond carries.
  std::vector<double> fed_back = values;
  fed_back[6] = 1;
  EXPECT_EQ(numbers(law.differentiate(here, values, 1)), numbers(law.differentiate(here, fed_back, 1)));
  EXPECT_GT(law.differentiate(here, values, 1).stiffness.kt, 0);
}

TEST(LawDerivatives, OfTheConcaveEndsByTheirRadiusAreTheIntegrandAtIt) {
  const BondLaw& law = *find_bond_law("concave-end");
  const double e = 5e10, pi = std::acos(-1.0);
  // The whole of the smaller sphere included, where the integrand has the slope of a root.
  for (const double r : {1e-4, 0.05, 0.1}) {
    const BondSite here = site(0.3 + 1e-3, 0.2, 0.1);
    const double fibre = here.gap() + 0.2 - std::sqrt(0.2 * 0.2 - r * r) + 0.1 - std::sqrt(0.1 * 0.1 - r * r);
    const BondDerivative found = law.differentiate(here, std::vector<double>{e, 0.2, r, not_given}, 2);
    EXPECT_NEAR(found.stiffness.kn * fibre / (2 * pi * e * r), 1, 1e-13);
    EXPECT_NEAR(found.stiffness.kb * fibre / (pi * e * r * r * r), 1, 1e-13);
    EXPECT_EQ(found.radius, 1);
  }
}

TEST(LawDerivatives, OfAStressRadiusThatIsNotThereAreZero) {
  const BondLaw& law = *find_bond_law("contact");
  const BondDerivative found =
      law.differentiate(site(1, 0.4, 0.4), std::vector<double>{1e8, 3e7, not_given}, 0);
  EXPECT_EQ(found.radius, 0);
  EXPECT_EQ(found.stiffness.kn, 1);
}

TEST(LawDerivatives, StayWithinDoublesInAnySystemOfUnits) {
  // The flexibilities' determinant is about 1e184: its square would leave the range.
  const BondLaw& law = *find_bond_law("two-segment");
  const BondSite metres = site(0.4, 0.11, 0.17), tiny = site(0.4e-50, 0.11e-50, 0.17e-50);
  const std::vector<double> values{7e10, 0.2, 0.6};
  for (std::size_t p = 0; p < values.size(); ++p) {
    const SectionStiffness one = law.differentiate(metres, values, p).stiffness;
    const SectionStiffness other = law.differentiate(tiny, values, p).stiffness;
    EXPECT_NEAR(other.kb / (one.kb * 1e-150), 1, 1e-13);
    EXPECT_NEAR(other.ks / (one.ks * 1e-50), 1, 1e-13);
  }
}

}  // namespace
}  // namespace bondstatic
