// [fracture]: what a run of fracture is told, and what it asks of the case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string head = R"([[particles]]
line = { from = [0, 0, 0], to = [4, 0, 0], count = 11 }
radius = 0.2
[[bonds]]
law = "timoshenko"
young = 200e9
poisson = 0.3
radius = 0.2
strength = { criterion = "edem-v2", critical_normal_stress = 5e6, critical_shear_stress = 8e6 }
[[supports]]
at = { id = 1 }
fix = "all"
)";

/// Line 13 and on.
std::string load(const std::string& load_case, const std::string& what = "force = [0, -1, 0]") {
  return "[[loads]]\nat = { id = 11 }\n" + what + "\n" +
         (load_case.empty() ? "" : "case = \"" + load_case + "\"\n");
}

std::string move(const std::string& load_case, const std::string& values, int particle = 11) {
  return "[[supports]]\nat = { id = " + std::to_string(particle) + " }\nvalues = { " + values + " }\n" +
         (load_case.empty() ? "" : "case = \"" + load_case + "\"\n");
}

FractureOptions read(const std::string& text, Purpose purpose = Purpose::fracture) {
  const Case c = read_case_text(text, {}, {}, purpose);
  EXPECT_THAT(c.warnings, IsEmpty());
  return c.fracture;
}

void expect_one_fault(const std::string& text, int line, int column, const std::string& message,
                      const std::string& cure, Purpose purpose = Purpose::fracture) {
  const auto faults = faults_of(text, {}, {}, purpose);
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.line, line);
  EXPECT_EQ(faults[0].place.column, column);
  EXPECT_THAT(faults[0].message, HasSubstr(message));
  EXPECT_THAT(faults[0].cure, HasSubstr(cure));
  EXPECT_FALSE(faults[0].cure.empty());
}

const std::string two_cases = head + load("confine", "force = [-1, 0, 0]") + load("press");  // to line 20

TEST(FractureOptionsOfACase, ReadsEveryKey) {
  const FractureOptions o = read(two_cases + R"([fracture]
pattern = "press"
preload = "confine"
control = "displacement"
max_breaks = 200
max_factor = 3
max_displacement = "2 mm"
load_drop = 0.5
save_every = 10
tie = 1e-6
)");
  EXPECT_EQ(o.pattern, 1);
  EXPECT_EQ(o.preload, 0);
  EXPECT_EQ(o.control, FractureControl::displacement);
  EXPECT_EQ(o.max_breaks, 200);
  EXPECT_EQ(o.max_factor, 3);
  EXPECT_EQ(o.max_displacement, 2e-3);
  EXPECT_EQ(o.load_drop, 0.5);
  EXPECT_EQ(o.save_every, 10);
  EXPECT_EQ(o.tie, 1e-6);
}

TEST(FractureOptionsOfACase, DefaultsAreThoseOfTheOptions) {
  const FractureOptions o = read(head + load("")), d;
  EXPECT_EQ(o.pattern, 0);
  EXPECT_EQ(o.preload, -1);
  EXPECT_EQ(o.control, FractureControl::event);
  EXPECT_EQ(o.max_breaks, d.max_breaks);
  EXPECT_EQ(o.max_factor, d.max_factor);
  EXPECT_EQ(o.max_displacement, d.max_displacement);
  EXPECT_EQ(o.load_drop, 1);
  EXPECT_EQ(o.save_every, 0);
  EXPECT_EQ(o.tie, 1e-9);
}

TEST(FractureOptionsOfACase, ThePatternIsTheOnlyCaseBesideThePreload) {
  EXPECT_EQ(read(head + load("press")).pattern, 0);
  EXPECT_EQ(read(two_cases + "[fracture]\npreload = \"confine\"").pattern, 1);
  EXPECT_EQ(read(two_cases + "[fracture]\npreload = \"press\"").pattern, 0);
}

TEST(FractureOptionsOfACase, DefaultsAreInTheResolvedCase) {
  const std::string resolved =
      read_case_text(two_cases + "[fracture]\npreload = \"confine\"", {}, {}, Purpose::fracture).resolved;
  for (const char* part : {"[fracture]", "pattern = \"press\"", "control = \"event\"", "load_drop = 1",
                           "save_every = 0", "tie = 1e-09"})
    EXPECT_THAT(resolved, HasSubstr(part));
  EXPECT_THAT(resolved, Not(HasSubstr("max_")));
  const Case again = read_case_text(resolved, {}, {}, Purpose::fracture);
  EXPECT_EQ(again.resolved, resolved);
  EXPECT_THAT(read_case_text(head + load(""), {}, {}, Purpose::fracture).resolved, HasSubstr("[fracture]"));
  EXPECT_THAT(read_case_text(head + load("")).resolved, Not(HasSubstr("[fracture]")));
}

TEST(FractureOptionsOfACase, SolveReadsItToo) {
  EXPECT_EQ(read(head + load("") + "[fracture]\nmax_breaks = 3", Purpose::statics).max_breaks, 3);
  expect_one_fault(head + load("") + "[fracture]\nmax_breaks = 0", 17, 14, "at least 1", "max_breaks",
                   Purpose::statics);
}

TEST(FractureOptionsOfACase, SettingsOfTheCommandLineReachThem) {
  EXPECT_EQ(
      read_case_text(head + load(""), {"fracture.control=load"}, {}, Purpose::fracture).fracture.control,
      FractureControl::load);
}

TEST(FractureOptionsOfACase, DisplacementHasTheDimensionOfThePattern) {
  const std::string most = "[fracture]\nmax_displacement = ";
  EXPECT_EQ(read(head + move("", "y = -1e-3") + most + "\"2 mm\"").max_displacement, 2e-3);
  EXPECT_EQ(read(head + load("", "moment = [0, 0, 1]") + most + "0.1").max_displacement, 0.1);
  expect_one_fault(head + load("", "moment = [0, 0, 1]") + most + "\"2 mm\"", 17, 20, "not of this dimension",
                   "max_displacement");
  expect_one_fault(head + move("", "rz = 1e-3") + most + "\"2 mm\"", 17, 20, "not of this dimension",
                   "max_displacement");
  const std::string cell = "[cell]\nsize = [4.4, 1, 1]\nperiodic = [\"x\"]\n";
  const std::string strain = "[[loads]]\nstrain = { xx = 1e-3 }\n";
  EXPECT_EQ(read(head + strain + cell + most + "0.01").max_displacement, 0.01);
  expect_one_fault(head + strain + cell + most + "\"2 mm\"", 19, 20, "not of this dimension",
                   "max_displacement");
}

struct Slip {
  std::string name, line;
  int column;
  std::string message, cure;
};

class BadFracture : public testing::TestWithParam<Slip> {};

TEST_P(BadFracture, IsOneFaultWithPlaceAndCure) {
  for (const Purpose purpose : {Purpose::statics, Purpose::fracture})
    expect_one_fault(head + load("press") + "[fracture]\n" + GetParam().line, 18, GetParam().column,
                     GetParam().message, GetParam().cure, purpose);
}

INSTANTIATE_TEST_SUITE_P(
    Slips, BadFracture,
    testing::Values(
        Slip{"UnknownKey", "max_break = 3", 1, "unknown key \"max_break\" in [fracture]", "max_breaks"},
        Slip{"Control", "control = \"force\"", 11, "event, load, displacement", "control"},
        Slip{"MaxBreaksZero", "max_breaks = 0", 14, "at least 1", "max_breaks"},
        Slip{"MaxFactorNegative", "max_factor = -1", 14, "must be positive", "max_factor"},
        Slip{"MaxFactorInfinite", "max_factor = inf", 14, "must be finite", "max_factor"},
        Slip{"MaxDisplacementUnit", "max_displacement = \"1 kN\"", 20, "not of this dimension", "m"},
        Slip{"LoadDropZero", "load_drop = 0", 13, "must be positive", "load_drop"},
        Slip{"LoadDropAboveOne", "load_drop = 1.5", 13, "load_drop = 1.5 must be at most 1", "part"},
        Slip{"SaveEveryNegative", "save_every = -1", 14, "at least 0", "save_every"},
        Slip{"TieNegative", "tie = -1e-9", 7, "must not be negative", "tie"},
        Slip{"TieOne", "tie = 1", 7, "tie = 1 must be below 1", "part"},
        Slip{"PatternUnknown", "pattern = \"pres\"", 11,
             "pattern = \"pres\" is no load case; there are: press", "\"press\""},
        Slip{"PreloadUnknown", "preload = \"gravity\"", 11, "there are: press", "choose"},
        Slip{"PatternIsNumber", "pattern = 1", 11, "must be a text", "quotes"},
        Slip{"Both", "pattern = \"press\"\npreload = \"press\"", 11, "both \"press\"", "leave preload out"},
        Slip{"NothingLeft", "preload = \"press\"", 11, "press is the only load case", "case ="}),
    [](const auto& test) { return test.param.name; });

TEST(FractureCases, ThePatternMustBeNamedAmongSeveral) {
  expect_one_fault(two_cases + "[fracture]\n", 21, 1, "there are: confine, press", "pattern = \"confine\"");
  expect_one_fault(two_cases, 1, 1, "there are: confine, press", "pattern = \"confine\"");
  expect_one_fault(head + load("") + "[fracture]\npattern = \"press\"", 17, 11, "names no load case",
                   "case = \"press\"");
}

TEST(FractureCases, NeedAStrength) {
  std::string weak = head;
  weak.erase(weak.find("strength"), weak.find("[[supports]]") - weak.find("strength"));
  expect_one_fault(weak + load(""), 4, 1, "no bonds have a strength", "add strength = { criterion");
  EXPECT_THAT(faults_of(weak + load("")), IsEmpty());
}

TEST(FractureCases, BlocksWithoutStrengthMayStandBesideOthers) {
  EXPECT_EQ(read(head + load("") +
                 "[[bonds]]\nlaw = \"timoshenko\"\nyoung = 1\npoisson = 0.3\nradius = 0.1\n"
                 "gap = 0.01\nexisting = \"add\"\n")
                .pattern,
            0);
}

const std::string confined = "[fracture]\npattern = \"press\"\npreload = \"confine\"\n";

TEST(FractureCases, WhatNamesNoCaseWouldCountTwice) {
  expect_one_fault(two_cases + load("") + confined, 21, 1, "loads of no named case would count twice",
                   "case = \"confine\" or case = \"press\"");
  expect_one_fault(two_cases + move("", "z = 1e-3", 6) + confined, 21, 1,
                   "prescribed motions of no named case", "case = \"press\"");
  EXPECT_THAT(faults_of(two_cases + load("") + confined), IsEmpty());  // for solve all is well
  EXPECT_EQ(read(two_cases + move("", "z = 0", 6) + confined).preload, 0);
  EXPECT_EQ(read(two_cases + load("") + "[fracture]\npattern = \"press\"").preload, -1);
}

TEST(FractureCases, BothHoldTheSame) {
  const std::string text = two_cases + move("press", "z = 0", 6);
  expect_one_fault(text + confined, 26, 11,
                   "particle 6 is held along z in load case \"press\", but not in load case \"confine\"",
                   "values = { z = 0 }");
  EXPECT_EQ(read(text + move("confine", "z = 1e-4", 6) + confined).preload, 0);
  EXPECT_EQ(read(text + "[fracture]\npattern = \"press\"").preload, -1);
}

TEST(FractureCases, SomethingScales) {
  expect_one_fault(head, 1, 1, "neither loads nor prescribed motions", "[[loads]]");
  expect_one_fault(head + load("confine") + load("press", "force = [0, 0, 0]") + confined, 22, 11,
                   "load case \"press\" has neither loads nor prescribed motions", "[[loads]]");
}

TEST(FractureCases, OneKindOfLoadScales) {
  expect_one_fault(two_cases + move("press", "z = 1e-3", 6) + move("confine", "z = 0", 6) + confined, 17, 1,
                   "scales loads here and prescribed motions in line 21", "case = \"confine\"");
  expect_one_fault(head + load("") + move("", "z = 1e-3", 6), 13, 1, "no one load and displacement",
                   "preload of [fracture]");
}

TEST(FractureCases, ACellsOwnStrainsArePatterns) {
  const std::string cell =
      "[cell]\nsize = [4.4, 1, 1]\n[[particles]]\nline = { from = [0, 0, 0], to = [4, 0, 0], count = 11 }\n"
      "radius = 0.2\n[[bonds]]\nlaw = \"timoshenko\"\nyoung = 1\npoisson = 0.3\nradius = 0.2\n"
      "strength = { criterion = \"edem-v2\", critical_normal_stress = 5e6, critical_shear_stress = 8e6 }\n";
  const FractureOptions o = read(cell + "[fracture]\npattern = \"yz\"\nmax_displacement = 0.01");
  EXPECT_EQ(o.pattern, 3);
  EXPECT_EQ(o.max_displacement, 0.01);
}

}  // namespace
}  // namespace bondstatic::test
