// Bounds, defaults and alternatives of the laws' parameters.
#include <limits>

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CompleteParameters, AcceptsTheTypicalInputsOfEveryLaw) {
  EXPECT_EQ(typical_inputs().size(), bond_laws().size());
  for (const auto& [name, inputs] : typical_inputs())
    EXPECT_THAT(complaints(name, inputs), ElementsAre()) << name;
}

TEST(CompleteParameters, RejectsEveryParameterBelowItsBoundAndWhatIsNotFinite) {
  for (const BondLaw& law : bond_laws()) {
    for (const Parameter& parameter : law.parameters) {
      const double below =
          parameter.lower_included ? std::nextafter(parameter.lower, -1e300) : parameter.lower;
      for (const double bad : {below, parameter.lower - 1, std::numeric_limits<double>::infinity()}) {
        std::vector<double> given(law.parameters.size(), not_given);
        given[std::size_t(law.find(parameter.name))] = bad;
        std::vector<std::string> found;
        complete_parameters(law, given, found);
        EXPECT_THAT(found, testing::Contains(testing::StartsWith(parameter.name + " = ")))
            << law.name << " " << parameter.name << " " << bad;
      }
    }
  }
}

TEST(CompleteParameters, SaysWhatWasFoundAndWhatIsAllowed) {
  Inputs inputs{{"young", -5}, {"poisson", 0.6}, {"radius", 0}};
  EXPECT_THAT(
      complaints("timoshenko", inputs),
      ElementsAre("young = -5: must be positive", "poisson = 0.6: must be greater than -1 and at most 0.5",
                  "radius = 0: must be positive"));
}

TEST(CompleteParameters, BoundsPoissonOpenBelowAndClosedAbove) {
  for (const double nu : {-0.999, 0.0, 0.5})
    EXPECT_THAT(complaints("timoshenko", {{"young", 1}, {"poisson", nu}}), ElementsAre());
  for (const double nu : {-1.0, std::nextafter(0.5, 1.0)})
    EXPECT_EQ(complaints("timoshenko", {{"young", 1}, {"poisson", nu}}).size(), 1u) << nu;
}

TEST(CompleteParameters, AllowsZeroShearButNotZeroNormalStiffness) {
  EXPECT_THAT(complaints("contact", {{"kn", 1}, {"ks", 0}}), ElementsAre());
  EXPECT_THAT(complaints("contact", {{"kn", 0}, {"ks", 0}}), ElementsAre("kn = 0: must be positive"));
  EXPECT_THAT(complaints("generic", {{"kn", 1}, {"ks", 0}, {"kt", 0}, {"kb", 0}}), ElementsAre());
  EXPECT_THAT(complaints("generic", {{"kn", 1}, {"ks", 0}, {"kt", -1}, {"kb", 0}}),
              ElementsAre("kt = -1: must not be negative"));
}

TEST(CompleteParameters, NamesWhatIsMissing) {
  EXPECT_THAT(complaints("timoshenko", {}),
              ElementsAre("young missing: give the Young's modulus E of the bond material",
                          "poisson missing: give the Poisson's ratio nu of the bond material"));
  EXPECT_THAT(complaints("parallel", {{"young", 1}}), ElementsAre("poisson missing: give poisson, or kappa"));
  EXPECT_THAT(
      complaints("pfc-parallel", {}),
      ElementsAre("normal_stiffness and shear_stiffness missing: give normal_stiffness and shear_stiffness, "
                  "or effective_modulus and stiffness_ratio"));
  EXPECT_THAT(complaints("edem-v2", {{"normal_stiffness", 1}, {"shear_stiffness", 1}}),
              ElementsAre(HasSubstr("torque_feedback missing")));
}

TEST(CompleteParameters, RejectsTwoWaysToSayTheSame) {
  EXPECT_THAT(complaints("parallel", {{"young", 1}, {"poisson", 0.2}, {"kappa", 2}}),
              ElementsAre("poisson and kappa exclude each other: give either poisson, or kappa"));
  EXPECT_THAT(
      complaints("timoshenko", {{"young", 1}, {"poisson", 0.2}, {"radius", 2}, {"radius_factor", 1}}),
      ElementsAre("radius and radius_factor exclude each other: give either radius, or radius_factor"));
  EXPECT_THAT(
      complaints("pfc-parallel", {{"normal_stiffness", 1}, {"shear_stiffness", 1}, {"stiffness_ratio", 1}}),
      ElementsAre(testing::StartsWith("normal_stiffness and stiffness_ratio exclude each other")));
}

TEST(CompleteParameters, RejectsHalfAWay) {
  EXPECT_THAT(complaints("pfc-parallel", {{"normal_stiffness", 1}}),
              ElementsAre("shear_stiffness missing: give normal_stiffness and shear_stiffness together"));
}

TEST(CompleteParameters, FillsInDefaultsOfTheChosenWayOnly) {
  const BondLaw& law = *find_bond_law("obermayr");
  std::vector<std::string> found;
  const auto value = [&](const std::vector<double>& values, const char* name) {
    return values[std::size_t(law.find(name))];
  };
  const auto plain = complete_parameters(law, in_order(law, {{"young", 1}, {"poisson", 0}}), found);
  EXPECT_EQ(value(plain, "radius_factor"), 1);
  EXPECT_EQ(value(plain, "shear_coefficient"), 0.9);
  EXPECT_TRUE(std::isnan(value(plain, "radius")));
  const auto given =
      complete_parameters(law, in_order(law, {{"young", 1}, {"poisson", 0}, {"radius", 3}}), found);
  EXPECT_EQ(value(given, "radius"), 3);
  EXPECT_TRUE(std::isnan(value(given, "radius_factor")));
  // Completing once more changes nothing.
  EXPECT_EQ(value(complete_parameters(law, given, found), "radius"), 3);
  EXPECT_EQ(value(complete_parameters(law, plain, found), "radius_factor"), 1);
  EXPECT_TRUE(found.empty());
}

TEST(CompleteParameters, WantsWholeSeedsAndTruthValues) {
  Inputs inputs{{"normal_stiffness", 1}, {"shear_stiffness", 1}, {"torque_feedback", 2}, {"seed", 1.5}};
  EXPECT_THAT(complaints("edem-v2", inputs), ElementsAre("seed = 1.5: must be a whole number",
                                                         "torque_feedback = 2: must be true or false"));
}

TEST(CompleteParameters, WantsScatterSmallerThanTheStiffness) {
  Inputs inputs{{"normal_stiffness", 2}, {"shear_stiffness", 1}, {"torque_feedback", 1}, {"normal_range", 2}};
  EXPECT_THAT(complaints("edem-v2", inputs),
              ElementsAre("normal_range = 2: must be smaller than normal_stiffness = 2"));
  inputs["normal_range"] = 1.5;
  inputs["shear_range"] = 1;
  EXPECT_THAT(complaints("edem-v2", inputs),
              ElementsAre("shear_range = 1: must be smaller than shear_stiffness = 1"));
}

TEST(CompleteParameters, RejectsMoreValuesThanTheLawTakes) {
  std::vector<std::string> found;
  complete_parameters(*find_bond_law("contact"), {1, 1, 1, 1}, found);
  EXPECT_THAT(found, ElementsAre("4 parameters given, but contact takes 3"));
}

}  // namespace
}  // namespace bondstatic
