// `strength` of [[bonds]]: criteria, scatter, columns of a bond file, and what is said of slips.
#include "bondstatic/strength.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/same_model.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Files = std::vector<std::pair<std::string, std::string>>;

const std::string edem = "criterion = \"edem-v2\", critical_normal_stress = 5e6, critical_shear_stress = 8e6";

/// The sound case; its bonds have the strength, in line 9.
std::string with_strength(const std::string& strength) {
  return sound_case({{8, "radius = 0.2\nstrength = { " + strength + " }"}});
}

BondStrength strength_of(const std::string& strength) {
  const Case c = read_case_text(with_strength(strength));
  EXPECT_THAT(c.warnings, IsEmpty());
  return c.model.blocks.at(0).strength.value();
}

TEST(Strength, IsReadInSilence) {
  const BondStrength strength = strength_of(edem);
  EXPECT_EQ(strength.criterion, "edem-v2");
  EXPECT_THAT(strength.parameters, ElementsAre(5e6, 8e6));
  EXPECT_THAT(strength.overrides, IsEmpty());
  EXPECT_EQ(strength.scatter, BondStrength::Scatter::none);
}

TEST(Strength, AbsentMeansThatBondsNeverBreak) {
  EXPECT_FALSE(read_case_text(sound_case()).model.blocks.at(0).strength);
}

TEST(Strength, UnitsAndATableOfItsOwnMakeTheSame) {
  const Case inlined = read_case_text(with_strength(edem));
  const Case apart =
      read_case_text(sound_case({{8,
                                  "radius = 0.2\n[bonds.strength]\ncriterion = \"edem-v2\"\n"
                                  "critical_normal_stress = \"5 MPa\"\ncritical_shear_stress = \"8 MPa\""}}));
  expect_same(inlined.model, apart.model);
  EXPECT_TRUE(apart.si);
  EXPECT_FALSE(inlined.si);
}

TEST(Strength, EveryCriterionOfTheCatalogueIsRead) {
  for (const StrengthCriterion& criterion : strength_criteria()) {
    std::string text = "criterion = \"" + criterion.name + "\"";
    std::vector<double> given;
    for (const Parameter& parameter : criterion.parameters) {
      given.push_back(parameter.lower + 0.25 + 0.0625 * double(given.size()));
      text += ", " + parameter.name + " = " + std::to_string(given.back());
    }
    EXPECT_EQ(strength_of(text).parameters, given) << criterion.name;
  }
}

TEST(Strength, NamesNoStrengthAsAKeyOfItsTableOrALaw) {
  for (const StrengthCriterion& criterion : strength_criteria())
    for (const Parameter& parameter : criterion.parameters) {
      EXPECT_THAT((std::vector<std::string>{"criterion", "scatter", "modulus", "variation", "range", "seed",
                                            "together"}),
                  Not(Contains(parameter.name)));
      for (const BondLaw& law : bond_laws()) EXPECT_LT(law.find(parameter.name), 0) << parameter.name;
    }
}

TEST(Strength, ScattersByOneNumberOrByStrength) {
  using Scatter = BondStrength::Scatter;
  const BondStrength weibull = strength_of(edem + ", scatter = \"weibull\", modulus = 8, seed = 3");
  EXPECT_EQ(weibull.scatter, Scatter::weibull);
  EXPECT_THAT(weibull.spread, ElementsAre(8, 8));
  EXPECT_EQ(weibull.seed, 3);
  EXPECT_FALSE(weibull.together);
  const BondStrength normal =
      strength_of(edem + ", scatter = \"normal\", variation = { critical_shear_stress = \"20 %\" }");
  EXPECT_EQ(normal.scatter, Scatter::normal);
  EXPECT_THAT(normal.spread, ElementsAre(0, 0.2));
  EXPECT_EQ(normal.seed, 1);
  const BondStrength uniform =
      strength_of(edem + ", scatter = \"uniform\", range = \"1 MPa\", together = true");
  EXPECT_EQ(uniform.scatter, Scatter::uniform);
  EXPECT_THAT(uniform.spread, ElementsAre(1e6, 1e6));
  EXPECT_TRUE(uniform.together);
}

TEST(Strength, OnlyStrengthsScatter) {
  EXPECT_THAT(strength_of("criterion = \"pfc-parallel\", tensile_strength = 1e6, cohesion = 2e6, "
                          "friction_angle = \"30 deg\", scatter = \"normal\", variation = 0.1")
                  .spread,
              ElementsAre(0.1, 0.1, 0, 0));
}

TEST(Strength, SwitchedOffScatterKeepsItsNumbers) {
  const BondStrength strength = strength_of(edem + ", scatter = \"none\", modulus = 8, seed = 3");
  EXPECT_EQ(strength.scatter, BondStrength::Scatter::none);
}

TEST(Strength, DefaultsAreInTheResolvedCase) {
  const std::string resolved =
      read_case_text(with_strength("criterion = \"pfc-parallel\", tensile_strength = 1e6, cohesion = 2e6"))
          .resolved;
  for (const char* part : {"moment_contribution = 1", "friction_angle = 0", "scatter = \"none\""})
    EXPECT_THAT(resolved, HasSubstr(part));
  EXPECT_THAT(resolved, Not(HasSubstr("seed")));
  EXPECT_THAT(read_case_text(with_strength(edem + ", scatter = \"weibull\", modulus = 8")).resolved,
              AllOf(HasSubstr("seed = 1"), HasSubstr("together = false")));
}

TEST(Strength, ResolvedCaseReadsTheSame) {
  for (const std::string& strength :
       {edem, edem + ", scatter = \"uniform\", range = { critical_normal_stress = 1e6 }",
        std::string("criterion = \"brown\", tensile_strength = 1, shear_strength = 2"),
        edem + ", scatter = \"none\", modulus = 3"}) {
    const Case first = read_case_text(with_strength(strength));
    const Case again = read_case_text(first.resolved);
    expect_same(first.model, again.model);
    EXPECT_EQ(first.resolved, again.resolved);
  }
}

TEST(Strength, SettingsOfTheCommandLineReachIt) {
  const Case c =
      read_case_text(with_strength(edem), {"bonds.0.strength.critical_normal_stress=\"7 MPa\"",
                                           "bonds.0.strength.scatter=weibull", "bonds.0.strength.modulus=4"});
  EXPECT_THAT(c.model.blocks.at(0).strength->parameters, ElementsAre(7e6, 8e6));
  EXPECT_THAT(c.model.blocks.at(0).strength->spread, ElementsAre(4, 4));
  const auto faults = faults_of(with_strength(edem), {"bonds.0.strength.critical_normal_stress=-7"});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.file, "--set bonds.0.strength.critical_normal_stress=-7");
}

// Columns of a bond file

const char* const listed = "file = \"bonds.csv\"\n";

std::string file_case(const std::string& strength, const std::string& law = "") {
  return sound_case(
      {{5, law.empty() ? sound_lines()[4] : law},
       {6, law.empty() ? sound_lines()[5] : ""},
       {7, law.empty() ? sound_lines()[6] : ""},
       {8, std::string(law.empty() ? "radius = 0.2\n" : "") + listed + "strength = { " + strength + " }"}});
}

TEST(StrengthColumns, AreEachBondsOwn) {
  const Case c =
      read_case_text(file_case(edem), {}, {{"bonds.csv", "a,b,critical_shear_stress\n1,2,1e6\n2,3,\n"}});
  EXPECT_THAT(c.warnings, IsEmpty());
  const BondStrength& strength = c.model.blocks.at(0).strength.value();
  EXPECT_THAT(strength.parameters, ElementsAre(5e6, 8e6));
  ASSERT_EQ(strength.overrides.size(), 1u);
  EXPECT_THAT(strength.overrides.at(1), ElementsAre(1e6, testing::IsNan()));
  EXPECT_TRUE(c.model.blocks.at(0).overrides.empty());
}

TEST(StrengthColumns, StandInForTheTable) {
  const std::string text = file_case("criterion = \"edem-v2\", critical_normal_stress = 5e6");
  const Case c = read_case_text(text, {}, {{"bonds.csv", "a,b,critical_shear_stress\n1,2,1e6\n2,3,2e6\n"}});
  const BondStrength& strength = c.model.blocks.at(0).strength.value();
  EXPECT_THAT(strength.parameters, ElementsAre(5e6, testing::IsNan()));
  EXPECT_THAT(strength.overrides.at(1), ElementsAre(1e6, 2e6));
  const auto faults = faults_of(text, {}, {{"bonds.csv", "a,b,critical_shear_stress\n1,2,1e6\n2,3,\n"}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.file, "bonds.csv");
  EXPECT_EQ(faults[0].place.line, 3);
  EXPECT_EQ(faults[0].place.column, 5);
  EXPECT_THAT(faults[0].message, HasSubstr("critical_shear_stress missing"));
}

TEST(StrengthColumns, GoWithTheBondsThatAreAdded) {
  const Case c = read_case_text(
      file_case(edem) +
          "[[bonds]]\nlaw = \"timoshenko\"\nyoung = 1e9\npoisson = 0.3\nradius = 0.1\n"
          "file = \"more.csv\"\nexisting = \"skip\"\nstrength = { " +
          edem + " }\n",
      {}, {{"bonds.csv", "a,b\n1,2\n"}, {"more.csv", "a,b,critical_normal_stress\n2,3,1\n1,2,2\n3,4,3\n"}});
  EXPECT_THAT(c.model.blocks.at(1).strength->overrides.at(0), ElementsAre(1, 3));
}

TEST(StrengthColumns, WithoutAStrengthAreNamedAsNotUsed) {
  const Case c = read_case_text(sound_case({{8, std::string("radius = 0.2\n") + listed}}), {},
                                {{"bonds.csv", "a,b,critical_shear_stress\n1,2,1e6\n"}});
  EXPECT_THAT(c.warnings, ElementsAre(HasSubstr("columns not used: critical_shear_stress")));
}

struct BadColumn {
  std::string name, content;
  int line, column;
  std::string message;
};

class BadStrengthColumn : public testing::TestWithParam<BadColumn> {};

TEST_P(BadStrengthColumn, IsOneFaultWithPlaceAndCure) {
  const auto faults = faults_of(file_case(edem), {}, {{"bonds.csv", GetParam().content}});
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.file, "bonds.csv");
  EXPECT_EQ(faults[0].place.line, GetParam().line);
  EXPECT_EQ(faults[0].place.column, GetParam().column);
  EXPECT_THAT(faults[0].message, HasSubstr(GetParam().message));
  EXPECT_FALSE(faults[0].cure.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Columns, BadStrengthColumn,
    testing::Values(BadColumn{"Negative", "a,b,critical_shear_stress\n1,2,1e6\n2,3,-1\n", 3, 5,
                              "critical_shear_stress = -1: must be positive"},
                    BadColumn{"Zero", "a,b,critical_shear_stress\n1,2,0\n", 2, 5, "must be positive"},
                    BadColumn{"Nan", "a,b,critical_shear_stress\n1,2,nan\n", 2, 5, "nan"},
                    BadColumn{"Text", "a,b,critical_shear_stress\n1,2,strong\n", 2, 5, "strong"},
                    BadColumn{"Misspelt", "a,b,critical_shaer_stress\n1,2,1\n", 1, 5,
                              "no parameter of law timoshenko or criterion edem-v2"}),
    [](const auto& test) { return test.param.name; });

TEST(StrengthColumns, AtMostTwentyRowsAreNamed) {
  std::string rows = "a,b,critical_shear_stress\n";
  for (int i = 0; i < 10; ++i) rows += "1,2,-1\n2,3,-1\n3,4,-1\n";
  EXPECT_EQ(faults_of(file_case(edem), {}, {{"bonds.csv", rows}}).size(), 20u);
}

TEST(StrengthColumns, OfAnotherCodesFileAreTaken) {
  const std::string table =
      "id,a,b,kn,ks,kt,kb,tensile_strength,shear_strength\n1,1,2,1e6,4e5,5,8,1e5,2e5\n2,2,3,1e6,4e5,5,8,3e5,"
      "4e5\n";
  const Case c =
      read_case_text(file_case("criterion = \"brown\"", "radius = 0.1"), {}, {{"bonds.csv", table}});
  EXPECT_THAT(c.warnings, IsEmpty());
  EXPECT_EQ(c.model.blocks.at(0).law, "generic");
  EXPECT_THAT(c.model.blocks.at(0).strength->overrides.at(1), ElementsAre(1e5, 3e5));
  EXPECT_THAT(c.model.blocks.at(0).strength->overrides.at(2), ElementsAre(2e5, 4e5));
}

// Sections

TEST(StrengthSection, ALawWithoutOneTakesNoStresses) {
  const auto faults = faults_of(sound_case(
      {{5, "law = \"contact\""}, {6, "kn = 1"}, {7, "ks = 1"}, {8, "strength = { " + edem + " }"}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 8);
  EXPECT_EQ(faults[0].place.column, 26);
  EXPECT_THAT(faults[0].message, HasSubstr("edem-v2 speaks of stresses"));
  EXPECT_THAT(faults[0].cure, AllOf(HasSubstr("radius"), HasSubstr("contact-bond")));
  EXPECT_THAT(faults_of(sound_case({{5, "law = \"contact\""},
                                    {6, "kn = 1\nradius = 0.1"},
                                    {7, "ks = 1"},
                                    {8, "strength = { " + edem + " }"}})),
              IsEmpty());
}

TEST(StrengthSection, IsAskedOfEachRow) {
  const std::string rows = "a,b,kn,ks,kt,kb,radius\n1,2,1,1,1,1,0.1\n2,3,1,1,1,1,\n";
  const auto faults = faults_of(file_case(edem, "law = \"generic\""), {}, {{"bonds.csv", rows}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.file, "bonds.csv");
  EXPECT_EQ(faults[0].place.line, 3);
  EXPECT_THAT(faults[0].message, HasSubstr("no radius"));
}

/// What the reader takes for granted of the laws.
TEST(StrengthSection, LawsWithoutOneAreThoseThatLeaveARadiusOpen) {
  for (const BondLaw& law : bond_laws()) {
    const Index radius = law.find("radius");
    std::vector<double> given(law.parameters.size(), not_given);
    for (std::size_t p = 0; p < given.size(); ++p) {
      const Parameter& parameter = law.parameters[p];
      if (!parameter.optional && std::isnan(parameter.default_value))
        given[p] = parameter.truth ? 1 : parameter.lower + 0.25;
    }
    std::vector<std::string> complaints;
    const auto values = complete_parameters(law, given, complaints);
    const bool open = radius >= 0 && std::isnan(values[std::size_t(radius)]);
    if (!complaints.empty()) continue;  // one of several ways to give the section has to be taken
    const double section = law.evaluate({2.5, 1, 1, 1, 2}, values).radius;
    EXPECT_EQ(std::isnan(section), law.name == "contact" || law.name == "generic") << law.name;
    EXPECT_TRUE(open || !std::isnan(section)) << law.name;
  }
}

// Slips

struct Slip {
  std::string name, strength;
  int column;
  std::string message, cure;
};

class BadStrength : public testing::TestWithParam<Slip> {};

TEST_P(BadStrength, IsOneFaultWithPlaceAndCureInEveryCommand) {
  for (const Purpose purpose : {Purpose::statics, Purpose::fracture}) {
    const auto faults = faults_of(with_strength(GetParam().strength), {}, {}, purpose);
    ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
    EXPECT_EQ(faults[0].place.line, 9);
    EXPECT_EQ(faults[0].place.column, GetParam().column);
    EXPECT_THAT(faults[0].message, HasSubstr(GetParam().message));
    EXPECT_THAT(faults[0].cure, HasSubstr(GetParam().cure));
    EXPECT_FALSE(faults[0].cure.empty());
  }
}

const std::string both = "critical_normal_stress = 5, critical_shear_stress = 8";
const std::string pfc = "criterion = \"pfc-parallel\", tensile_strength = 5, cohesion = 8";
const std::string forces =
    "criterion = \"bpm-rotational\", critical_normal_force = 1, critical_shear_force = 1, "
    "critical_twisting_moment = 1, critical_bending_moment = 1";

INSTANTIATE_TEST_SUITE_P(
    Slips, BadStrength,
    testing::Values(
        Slip{"NoCriterion", both, 12, "strength needs criterion", "one of: edem-v2"},
        Slip{"UnknownCriterion", "criterion = \"mohr\", cohesion = 3", 26, "criterion = \"mohr\" is unknown",
             "laws --strengths"},
        Slip{"NearCriterion", "criterion = \"edem_v2\", " + both, 26, "is unknown", "\"edem-v2\""},
        Slip{"CriterionIsNumber", "criterion = 2, " + both, 26, "must be a text", "quotes"},
        Slip{"Missing", "criterion = \"edem-v2\", critical_normal_stress = 5", 12,
             "critical_shear_stress missing", "laws --strengths edem-v2"},
        Slip{"Negative", "criterion = \"edem-v2\", critical_normal_stress = -5, critical_shear_stress = 8",
             62, "critical_normal_stress = -5: must be positive", "Pa"},
        Slip{"Nan", "criterion = \"edem-v2\", critical_normal_stress = nan, critical_shear_stress = 8", 62,
             "must be finite", "Pa"},
        Slip{"Infinite", "criterion = \"edem-v2\", critical_normal_stress = inf, critical_shear_stress = 8",
             62, "must be finite", "Pa"},
        Slip{"Zero", "criterion = \"edem-v2\", critical_normal_stress = 0, critical_shear_stress = 8", 62,
             "must be positive", "Pa"},
        Slip{"Unit", "criterion = \"edem-v2\", critical_normal_stress = \"5 N\", critical_shear_stress = 8",
             62, "not of this dimension", "Pa"},
        Slip{"UnknownKey", "criterion = \"edem-v2\", critical_normal_stres = 4, " + both, 37,
             "unknown key \"critical_normal_stres\" in strength", "critical_normal_stress"},
        Slip{"Angle", pfc + ", friction_angle = 30", 95, "friction_angle = 30", "deg"},
        Slip{"UnknownScatter", edem + ", scatter = \"gauss\"", 106, "none, weibull, normal, uniform", ""},
        Slip{"NoModulus", edem + ", scatter = \"weibull\"", 12, "strength needs modulus", "one number"},
        Slip{"ModulusZero", edem + ", scatter = \"weibull\", modulus = 0", 127, "must be positive",
             "modulus"},
        Slip{"ModulusOfNormal", edem + ", scatter = \"normal\", variation = 0.1, modulus = 8", 143,
             "modulus does not go with scatter = \"normal\"", "variation"},
        Slip{"ModulusWithoutScatter", edem + ", modulus = 8", 106, "do not scatter", "scatter = \"weibull\""},
        Slip{"SeedWithoutScatter", edem + ", seed = 8", 103, "do not scatter", "remove it"},
        Slip{"SeedBroken", edem + ", scatter = \"weibull\", modulus = 8, seed = 1.5", 137, "whole number",
             "seed"},
        Slip{"RangeTooWide", edem + ", scatter = \"uniform\", range = { critical_normal_stress = 6e6 }", 152,
             "range = 6000000 must be at most critical_normal_stress = 5000000", "narrow"},
        Slip{"RangeOfTwoDimensions", forces + ", scatter = \"uniform\", range = 0.5", 185,
             "not of one dimension", "range = { critical_normal_force"},
        Slip{"SpreadOfNoStrength", pfc + ", scatter = \"normal\", variation = { friction_angle = 0.1 }", 112,
             "unknown key \"friction_angle\" in variation", "known here: tensile_strength, cohesion"},
        Slip{"SpreadEmpty", edem + ", scatter = \"normal\", variation = {}", 128, "variation is empty",
             "name"}),
    [](const auto& test) { return test.param.name; });

TEST(BadStrengths, ATableIsNeeded) {
  const auto faults = faults_of(sound_case({{8, "radius = 0.2\nstrength = 5e6"}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 9);
  EXPECT_THAT(faults[0].message, HasSubstr("must be a table"));
}

TEST(BadStrengths, AreSaidTogetherWithThoseOfTheLaw) {
  EXPECT_EQ(faults_of(sound_case({{6, "young = -1"},
                                  {8,
                                   "radius = 0.2\nstrength = { criterion = \"edem-v2\", "
                                   "critical_normal_stress = -5 }"}}))
                .size(),
            3u);
}

}  // namespace
}  // namespace bondstatic::test
