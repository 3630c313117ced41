// Each criterion against numbers by hand and against its source's own formula, written out apart.
#include <numbers>
#include <set>

#include "bond/strength_fixture.hpp"

namespace bondstatic {
namespace {

using std::numbers::pi;
using testing::ElementsAre;

/// Magnitudes, as sources write them; `moment_a` and `moment_b` at the particles' centres.
struct Carried {
  double normal, shear, twisting, middle, contact, moment_a, moment_b;
};

/// In three dimensions, by moving force and moment from the contact point.
Carried carried_by(const SectionVector& q, const BondSection& bond) {
  const Vector3 force(q.normal, q.shear.x(), q.shear.y()), moment(q.twisting, q.bending.x(), q.bending.y());
  const auto bending = [&](double at) {
    const Vector3 from_there((bond.fraction - at) * bond.length, 0, 0);
    return (moment + from_there.cross(force)).tail<2>().norm();
  };
  return {q.normal,   q.shear.norm(), std::abs(q.twisting), bending(0.5), bending(bond.fraction),
          bending(0), bending(1)};
}

using Truth = std::function<std::vector<double>(const Carried&, double radius, const Inputs&)>;

/// Utilisations as the sources have them, in the order of the criterion's modes.
std::map<std::string, Truth> truths() {
  const auto area = [](double r) { return pi * r * r; };
  return {
      {"edem-v2",  // the page: J = pi r^4 / 2
       [=](const Carried& c, double r, const Inputs& in) {
         const double j = pi * std::pow(r, 4) / 2;
         return std::vector{(c.normal / area(r) + 2 * c.contact / j * r) / in.at("critical_normal_stress"),
                            (c.shear / area(r) + c.twisting / j * r) / in.at("critical_shear_stress")};
       }},
      {"pfc-parallel",  // I = pi r^4 / 4, twist with half of r/I, as in pb's smax
       [=](const Carried& c, double r, const Inputs& in) {
         const double i = pi * std::pow(r, 4) / 4, beta = in.at("moment_contribution");
         const double sigma = c.normal / area(r) + beta * c.contact * r / i;
         const double tau = c.shear / area(r) + beta * c.twisting * 0.5 * r / i;
         const double friction = std::tan(in.at("friction_angle")) * c.normal / area(r);
         return std::vector{sigma / in.at("tensile_strength"), (tau + friction) / in.at("cohesion")};
       }},
      {"brown",
       [=](const Carried& c, double r, const Inputs& in) {
         const double i = pi * std::pow(r, 4) / 4, moment = std::max(c.moment_a, c.moment_b);
         return std::vector{
             (-c.normal / area(r) + moment * r / i) / in.at("compressive_strength"),
             (c.normal / area(r) + moment * r / i) / in.at("tensile_strength"),
             (4 * c.shear / (3 * area(r)) + c.twisting * r / (2 * i)) / in.at("shear_strength")};
       }},
      {"musen",  // diameter, axial moment pi d^4 / 64
       [=](const Carried& c, double r, const Inputs& in) {
         const double d = 2 * r, axial = pi * std::pow(d, 4) / 64;
         return std::vector{
             (c.normal / area(r) + c.middle * d / (2 * axial)) / in.at("normal_strength"),
             (c.shear / area(r) + c.twisting * d / (4 * axial)) / in.at("tangential_strength")};
       }},
      {"bpm-rotational",
       [](const Carried& c, double, const Inputs& in) {
         return std::vector{
             c.normal / in.at("critical_normal_force") + c.shear / in.at("critical_shear_force") +
             c.middle / in.at("critical_bending_moment") + c.twisting / in.at("critical_twisting_moment")};
       }},
      {"contact-bond", [](const Carried& c, double, const Inputs& in) {
         return std::vector{c.normal / in.at("critical_tensile_force"),
                            c.shear / in.at("critical_shear_force")};
       }}};
}

TEST(StrengthCriteria, AreTheFormulasOfTheirSources) {
  const auto inputs = typical_strengths();
  ASSERT_EQ(truths().size(), strength_criteria().size());
  RandomResultants random;
  for (const auto& [name, truth] : truths()) {
    const StrengthCriterion& criterion = *find_strength_criterion(name);
    for (int k = 0; k < 2000; ++k) {
      const BondSection bond = random.section();
      const SectionVector q = random.resultants();
      const std::vector<FailureMode> modes = failure_modes(name, inputs.at(name), bond);
      const std::vector<double> expected = truth(carried_by(q, bond), bond.radius, inputs.at(name));
      ASSERT_EQ(expected.size(), criterion.modes.size());
      const auto worst = std::max_element(expected.begin(), expected.end());
      const Utilisation found = utilisation(modes, bond.length, bond.fraction, q);
      // Rounding of a sum of terms of at most about 10.
      ASSERT_NEAR(found.value, std::max(0.0, *worst), 1e-14) << name;
      if (*worst > 1e-12) {
        ASSERT_EQ(found.mode, worst - expected.begin()) << name;
      }
    }
  }
}

TEST(StrengthCriteria, EdemAgreesWithTheStressesOfTheResults) {
  RandomResultants random;
  for (int k = 0; k < 200; ++k) {
    const BondSection bond = random.section();
    const SectionVector q = random.resultants();
    const SectionStress stress =
        section_stress({q.normal, q.shear.norm(), q.twisting, q.bending.norm()}, bond.radius);
    const auto modes = failure_modes("edem-v2", typical_strengths().at("edem-v2"), bond);
    EXPECT_NEAR(utilisation_of(modes, bond, q), std::max({0.0, stress.sigma / 5, stress.tau / 3}), 1e-14);
  }
}

TEST(StrengthCriteria, ByHand) {
  // r = 0.5: A = pi/4, I = pi/64, J = pi/32. N = 3, S = 2, T = 5, M = 7 at the contact point.
  const BondSection bond{0.5, 4, 0.5};
  const SectionVector q{3, -5, {2, 0}, {0, 7}};
  const auto value = [&](const std::string& name, const Inputs& inputs) {
    return utilisation_of(failure_modes(name, inputs, bond), bond, q);
  };
  const double inf = std::numeric_limits<double>::infinity();
  // sigma = 3 * 4/pi + 7 * 32/pi, tau = 2 * 4/pi + 5 * 16/pi
  EXPECT_NEAR(value("edem-v2", {{"critical_normal_stress", 236 / pi}, {"critical_shear_stress", inf}}), 1,
              1e-15);
  EXPECT_NEAR(value("edem-v2", {{"critical_normal_stress", inf}, {"critical_shear_stress", 88 / pi}}), 1,
              1e-15);
  EXPECT_NEAR(value("musen", {{"normal_strength", 236 / pi}, {"tangential_strength", inf}}), 1, 1e-15);
  EXPECT_NEAR(value("musen", {{"normal_strength", inf}, {"tangential_strength", 88 / pi}}), 1, 1e-15);
  // beta = 1/2: sigma = (12 + 112)/pi, tau = (8 + 40)/pi; friction of 45 degrees adds 12/pi
  const Inputs half{{"moment_contribution", 0.5}, {"friction_angle", pi / 4}};
  Inputs pfc = half;
  pfc.insert({{"tensile_strength", 124 / pi}, {"cohesion", inf}});
  EXPECT_NEAR(value("pfc-parallel", pfc), 1, 1e-15);
  pfc = half;
  pfc.insert({{"tensile_strength", inf}, {"cohesion", 60 / pi}});
  EXPECT_NEAR(value("pfc-parallel", pfc), 1, 1e-15);
  // M + 2 e_x x S = (7 + 4) e_z at a, 3 e_z at b: sigma = (12 + 11 * 32)/pi, (-12 + 11 * 32)/pi
  EXPECT_NEAR(value("brown", {{"tensile_strength", 364 / pi}, {"shear_strength", inf}}), 1, 1e-15);
  EXPECT_NEAR(value("brown",
                    {{"compressive_strength", 340 / pi}, {"tensile_strength", inf}, {"shear_strength", inf}}),
              1, 1e-15);
  EXPECT_NEAR(value("brown", {{"tensile_strength", inf}, {"shear_strength", (32 / 3.0 + 80) / pi}}), 1,
              1e-15);
  EXPECT_NEAR(value("brown", {{"tensile_strength", inf}, {"shear_strength", 88 / pi}, {"shear_factor", 1}}),
              1, 1e-15);
  // 3/12 + 2/8 + 5/20 + 7/28
  EXPECT_NEAR(value("bpm-rotational", {{"critical_normal_force", 12},
                                       {"critical_shear_force", 8},
                                       {"critical_twisting_moment", 20},
                                       {"critical_bending_moment", 28}}),
              1, 1e-15);
  EXPECT_NEAR(value("contact-bond", {{"critical_tensile_force", 3}, {"critical_shear_force", 4}}), 1, 1e-15);
  EXPECT_NEAR(value("contact-bond", {{"critical_tensile_force", 6}, {"critical_shear_force", 2}}), 1, 1e-15);
}

TEST(StrengthCriteria, CompressionHoldsWhatTensionBreaks) {
  const BondSection bond{0.5, 4, 0.5};
  for (const auto& [name, inputs] : typical_strengths()) {
    const auto modes = failure_modes(name, inputs, bond);
    const SectionVector pull{2, 0, {0, 0}, {0, 0}}, push{-2, 0, {0, 0}, {0, 0}};
    EXPECT_GT(utilisation_of(modes, bond, pull), 0) << name;
    const Utilisation pushed = utilisation(modes, bond.length, bond.fraction, push);
    if (name == "brown") {
      EXPECT_NEAR(pushed.value, 2 / (pi * 0.25) / 30, 1e-15);
      EXPECT_EQ(find_strength_criterion(name)->modes[std::size_t(pushed.mode)], "compression");
    } else {
      EXPECT_EQ(pushed.value, 0) << name;
      EXPECT_EQ(pushed.mode, -1) << name;
    }
  }
}

TEST(StrengthCriteria, PfcShearFailsWhereItsStrengthIsReached) {
  // tau against c - sigma_n tan(phi), which grows under compression.
  const BondSection bond{0.5, 4, 0.5};
  const auto modes = failure_modes("pfc-parallel", typical_strengths().at("pfc-parallel"), bond);
  RandomResultants random;
  for (int k = 0; k < 500; ++k) {
    const SectionVector q = random.resultants(3);
    const double area = pi * 0.25, inertia = pi / 64;
    const double sigma_n = q.normal / area;
    const double tau = q.shear.norm() / area + 0.7 * std::abs(q.twisting) * 0.25 / inertia;
    const double tension = sigma_n + 0.7 * q.bending.norm() * 0.5 / inertia;
    const bool broken = tension >= 5 || tau >= 4 - sigma_n * std::tan(0.6);
    EXPECT_EQ(utilisation_of(modes, bond, q) >= 1, broken);
  }
}

TEST(StrengthCriteria, AreSoundAsACatalogue) {
  std::set<std::string> names;
  for (const StrengthCriterion& criterion : strength_criteria()) {
    EXPECT_TRUE(names.insert(criterion.name).second);
    EXPECT_EQ(find_strength_criterion(criterion.name), &criterion);
    EXPECT_EQ(criterion.scatters.size(), criterion.parameters.size());
    EXPECT_FALSE(criterion.source.empty());
    EXPECT_FALSE(criterion.modes.empty());
    std::set<int> said;
    for (const FailureMode& mode :
         failure_modes(criterion.name, typical_strengths().at(criterion.name), {0.5, 4, 0.5})) {
      said.insert(mode.name);
      EXPECT_TRUE(mode.shear >= 0 && mode.twisting >= 0 && mode.bending >= 0) << "convex";
      EXPECT_TRUE(mode.at >= 0 && mode.at <= 1);
    }
    EXPECT_EQ(said.size(), criterion.modes.size());
    EXPECT_EQ(*said.rbegin(), int(criterion.modes.size()) - 1);
    for (std::size_t p = 0; p < criterion.parameters.size(); ++p) {
      EXPECT_EQ(criterion.find(criterion.parameters[p].name), Index(p));
      // Columns of a bond file stand next to those of the law.
      for (const BondLaw& law : bond_laws())
        EXPECT_EQ(law.find(criterion.parameters[p].name), -1) << law.name << " " << criterion.name;
    }
  }
  EXPECT_EQ(find_strength_criterion("edem"), nullptr);
}

TEST(CompleteStrengths, FillsInDefaultsAndInfinity) {
  const auto completed = [](const std::string& name, const Inputs& inputs) {
    std::vector<std::string> found;
    const StrengthCriterion& criterion = *find_strength_criterion(name);
    const auto values = complete_strengths(criterion, strengths_in_order(criterion, inputs), found);
    EXPECT_THAT(found, ElementsAre());
    EXPECT_EQ(complete_strengths(criterion, values, found), values) << "once more changes nothing";
    EXPECT_THAT(found, ElementsAre());
    return values;
  };
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(completed("pfc-parallel", {{"tensile_strength", 5}, {"cohesion", 4}}), ElementsAre(5, 4, 0, 1));
  EXPECT_THAT(completed("brown", {{"tensile_strength", 5}, {"shear_strength", 4}}),
              ElementsAre(inf, 5, 4, 4.0 / 3));
  EXPECT_THAT(completed("musen", {{"normal_strength", inf}, {"tangential_strength", 1}}),
              ElementsAre(inf, 1));
}

TEST(CompleteStrengths, SaysWhatIsMissingOrOutOfBounds) {
  EXPECT_THAT(strength_complaints("brown", {{"tensile_strength", -5}}),
              ElementsAre("tensile_strength = -5: must be positive",
                          "shear_strength missing: give the shear strength of the bond"));
  EXPECT_THAT(
      strength_complaints("contact-bond", {{"critical_tensile_force", 0}, {"critical_shear_force", 1}}),
      ElementsAre("critical_tensile_force = 0: must be positive"));
  EXPECT_THAT(strength_complaints("pfc-parallel", {{"tensile_strength", 1},
                                                   {"cohesion", -std::numeric_limits<double>::infinity()},
                                                   {"friction_angle", 30},
                                                   {"moment_contribution", 1.5}}),
              ElementsAre("cohesion = -inf: must be finite",
                          "friction_angle = 30: must be at least 0 and at most 1.55",
                          "moment_contribution = 1.5: must be at least 0 and at most 1"));
  std::vector<std::string> found;
  complete_strengths(*find_strength_criterion("musen"), {1, 1, 1}, found);
  EXPECT_THAT(found, ElementsAre("3 strengths given, but musen takes 2"));
}

TEST(CompleteStrengths, RejectsEveryParameterBelowItsBound) {
  for (const auto& [name, inputs] : typical_strengths())
    for (const Parameter& parameter : find_strength_criterion(name)->parameters) {
      Inputs bad = inputs;
      bad[parameter.name] =
          parameter.lower_included ? std::nextafter(parameter.lower, -1e300) : parameter.lower;
      EXPECT_THAT(strength_complaints(name, bad), ElementsAre(testing::StartsWith(parameter.name + " = ")));
    }
}

}  // namespace
}  // namespace bondstatic
