// Quasi-static fracture against closed forms and against plain solves of the broken model.
#include "bondstatic/fracture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

constexpr double pi = std::numbers::pi;

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// Fibres side by side between a fixed row and a row that moves by 1 along them, each of normal stiffness
/// `kn` and its own tensile strength.
Model bundle(const std::vector<double>& strengths, double kn) {
  Model model;
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    add_particle(model, Vector3(double(i), 0, 0), 0.4);
    add_particle(model, Vector3(double(i), 0, 1), 0.4);
  }
  model.blocks.push_back(block("generic", {{"kn", kn}, {"ks", kn / 2}, {"kt", kn / 3}, {"kb", kn / 4}}));
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    add_bond(model, Index(2 * i), Index(2 * i + 1));
    fix_all(model, Index(2 * i));
    fix_all(model, Index(2 * i + 1), vector6(0, 0, 1));
  }
  model.blocks[0].strength =
      strength("contact-bond", {{"critical_tensile_force", 1}, {"critical_shear_force", 1e9}});
  const StrengthCriterion& criterion = *find_strength_criterion("contact-bond");
  model.blocks[0].strength->overrides[std::size_t(criterion.find("critical_tensile_force"))] = strengths;
  return model;
}

TEST(FibreBundle, CarriesWhatIsWholeAndDissipatesEachFibresEnergy) {
  const double kn = 3e5;
  std::vector<double> strengths;
  for (int i = 0; i < 40; ++i) strengths.push_back(1e3 * (1 + i * 0.37 + 0.01 * (i * i % 7)));
  std::reverse(strengths.begin(), strengths.end());
  FractureOptions options;
  options.control = FractureControl::displacement;
  const Fracture found = fracture(bundle(strengths, kn), options, one_thread());
  std::sort(strengths.begin(), strengths.end());
  ASSERT_EQ(found.events.size(), strengths.size());
  EXPECT_EQ(found.end, FractureEnd::separated);
  double dissipated = 0;
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const FractureEvent& event = found.events[i];
    const double d = strengths[i] / kn, whole = double(strengths.size() - i);
    dissipated += kn * d * d / 2;
    EXPECT_NEAR(event.displacement / d, 1, 1e-15) << i;
    EXPECT_NEAR(event.load / (kn * d * whole), 1, 1e-15) << i;
    EXPECT_NEAR(event.load_after, kn * d * (whole - 1), 1e-15 * event.load) << i;
    EXPECT_NEAR(event.dissipated / dissipated, 1, 1e-14) << i;
    EXPECT_NEAR(event.strain_energy, kn * d * d / 2 * (whole - 1), 1e-15 * kn * d * d / 2 * whole) << i;
  }
  EXPECT_LT(found.report.energy_balance, 1e-14);
}

TEST(FibreBundle, UnderDeadLoadBreaksInAvalanches) {
  const double kn = 1e5;
  // Thresholds such that the third break of four brings the rest down.
  const std::vector<double> strengths{10, 20, 30, 31, 32, 100};
  Model model = bundle(strengths, kn);
  FractureOptions options;
  options.control = FractureControl::load;
  const Fracture found = fracture(model, options, one_thread());
  // F(d) = k d (whole): 60, then 100, then 120 > 93 > 64 ... : all but the last break at 120.
  ASSERT_EQ(found.events.size(), 6u);
  const double load[] = {60, 100, 120, 120, 120, 120};
  const Index avalanche[] = {1, 2, 3, 3, 3, 3};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(found.events[i].load / load[i], 1, 1e-14) << i;
    EXPECT_EQ(found.events[i].avalanche, avalanche[i]) << i;
  }
  // What goes beyond is kinetic energy in nature; here it is released with the bonds.
  EXPECT_LT(found.report.energy_balance, 1e-14);
}

TEST(FibreBundle, EqualFibresBreakTogether) {
  const Fracture found = fracture(bundle({5, 5, 5, 5}, 1e5), {}, one_thread());
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_EQ(found.events[0].bonds.size(), 4u);
  EXPECT_EQ(found.end, FractureEnd::separated);
}

constexpr Index chain_bonds = 20;
constexpr double chain_length = 10, chain_radius = 0.05, chain_strength = 3e6;

/// Held at its first particle; only the normal stress can break it.
Model breakable_chain() {
  Model model = chain(block("timoshenko", {{"young", 1e10}, {"poisson", 0.25}, {"radius", chain_radius}}),
                      Vector3::Zero(), Vector3(chain_length, 0, 0), chain_bonds, 0.2);
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", chain_strength}, {"critical_shear_stress", 1e12}});
  return model;
}

/// Tip load P across a chain of n bonds: the root bond's stress is that of the moment at its contact point.
TEST(FracturedCantilever, BreaksAtTheRootAtTheClosedFormLoad) {
  const double axial = 7;
  Model model = breakable_chain();
  load(model, chain_bonds, vector6(axial, 0, -1));
  const Fracture found = fracture(model, {}, one_thread());
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_EQ(found.events[0].bonds[0].bond, 0);
  const double area = pi * chain_radius * chain_radius, inertia = pi * std::pow(chain_radius, 4) / 4;
  const double lever = chain_length - chain_length / double(2 * chain_bonds);
  EXPECT_NEAR(found.events[0].factor / (chain_strength / (axial / area + lever * chain_radius / inertia)), 1,
              1e-13);
  EXPECT_EQ(found.end, FractureEnd::separated);
  EXPECT_NE(found.reason.find("free"), std::string::npos) << found.reason;
}

/// A preload of tension on the same chain: the factor is what is missing.
TEST(FracturedCantilever, PreloadCountsAndDoesNotScale) {
  const double tension = 9e3;
  Model model = breakable_chain();
  model.load_cases = {"tension", "bend"};
  load(model, chain_bonds, vector6(tension, 0, 0), 0);
  load(model, chain_bonds, vector6(0, 1, -2), 1);
  FractureOptions options;
  options.preload = 0;
  options.pattern = 1;
  const Fracture found = fracture(model, options, one_thread());
  const double area = pi * chain_radius * chain_radius, inertia = pi * std::pow(chain_radius, 4) / 4;
  const double lever = chain_length - chain_length / double(2 * chain_bonds);
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_NEAR(found.events[0].factor /
                  ((chain_strength - tension / area) / (std::sqrt(5.0) * lever * chain_radius / inertia)),
              1, 1e-13);
}

/// W. Weibull's fibres: N exp(-(F / F_0)^m) of them hold F each; the largest sum is at F = F_0 m^(-1/m).
TEST(FibreBundle, OfWeibullStrengthsCarriesDanielsLoad) {
  const std::size_t fibres = 1000;
  const double kn = 1e5, scale = 50, modulus = 4;
  Model model = bundle(std::vector<double>(fibres, scale), kn);
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {modulus, 0};
  model.blocks[0].strength->seed = 1;
  FractureOptions options;
  options.control = FractureControl::displacement;
  const Fracture found = fracture(model, options, one_thread());
  ASSERT_EQ(found.events.size(), fibres);
  double peak = 0, apart = 0;
  for (std::size_t i = 0; i < fibres; ++i) {
    peak = std::max(peak, found.events[i].load);
    const double broken = 1 - std::exp(-std::pow(kn * found.events[i].displacement / scale, modulus));
    apart = std::max(apart, std::abs(broken - (double(i) + 0.5) / double(fibres)));
  }
  const double n = double(fibres), whole = std::exp(-1 / modulus);
  const double expected = n * scale * std::pow(modulus, -1 / modulus) * whole;
  // Daniels (1945): normal about that, with the binomial spread of those that hold; three times that.
  EXPECT_NEAR(peak / expected, 1, 3 * std::sqrt((1 - whole) / (whole * n)));
  EXPECT_LT(apart, 1.63 / std::sqrt(n));  // Kolmogorov and Smirnov at 1 %
}

/// Between two held particles a third is turned by m = 1 about y; both bonds shear by theta L / 2 and bend by
/// theta. Without feedback the shear forces alone balance m; the bending moment is there all the same.
TEST(FracturedTorqueFeedback, OffMomentsCountForTheStrengthThoughNotForBalance) {
  const double sn = 3e9, st = 1e9, radius = 0.1, length = 0.5, critical = 2e5;
  const double polar = pi * std::pow(radius, 4) / 2, kb = sn * polar / 2, ks = st * pi * radius * radius;
  for (const bool feedback : {false, true}) {
    Model model = chain(
        block("edem-v2",
              {{"normal_stiffness", sn}, {"shear_stiffness", st}, {"torque_feedback", double(feedback)}}),
        Vector3::Zero(), Vector3(2 * length, 0, 0), 2, radius);
    fix_all(model, 2);
    // Nothing else would keep it from turning about the axis.
    model.supports.push_back({1, {false, false, false, true, false, false}, Vector6::Zero(), every_case});
    load(model, 1, vector6(0, 0, 0, 0, 1, 0));
    model.blocks[0].strength =
        strength("edem-v2", {{"critical_normal_stress", critical}, {"critical_shear_stress", 1e12}});
    const Fracture found = fracture(model, {}, one_thread());
    const double theta = 1 / (ks * length * length / 2 + (feedback ? 2 * kb : 0));
    ASSERT_EQ(found.events.size(), 1u);
    EXPECT_EQ(found.events[0].bonds.size(), 2u);
    EXPECT_NEAR(found.events[0].factor * 2 * kb * theta * radius / polar / critical, 1, 1e-14);
    EXPECT_NEAR(found.events[0].displacement / (found.events[0].factor * theta), 1, 1e-14);
    EXPECT_EQ(found.end, FractureEnd::separated);
  }
}

/// A branch that only rides along carries rounding, and must not break by it.
TEST(FracturedCantilever, WhatCarriesNothingNeverBreaks) {
  Model model = chain(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(10, 1, 3), 10, 0.5);
  model.blocks.push_back(model.blocks[0]);
  for (int i = 1; i <= 3; ++i)
    add_bond(model, i == 1 ? 5 : 9 + i, add_particle(model, Vector3(5.5, i, 0), 0.5), 1);
  model.blocks[1].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e2}, {"critical_shear_stress", 1e2}});
  load(model, 10, vector6(1, 0.3, -0.4));
  const Fracture found = fracture(model, {}, one_thread());
  EXPECT_TRUE(found.events.empty());
  EXPECT_EQ(found.end, FractureEnd::unbreakable);
}

}  // namespace
}  // namespace bondstatic::test
