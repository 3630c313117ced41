// What cannot be calibrated is refused, all of it at once, each with its cure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/calibration.hpp"
#include "bondstatic/error.hpp"
#include "calibration/tests_of_models.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

/// A cantilever with young and poisson, and targets for all outputs, to be spoilt.
struct Asked {
  std::vector<CalibrationTest> tests{cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}})};
  std::vector<CalibrationParameter> parameters{
      {.name = "young", .lower = 1e9, .upper = 1e12},
      {.name = "poisson", .lower = 0, .upper = 0.5, .logarithmic = false}};
  std::vector<CalibrationTarget> targets;
  CalibrationOptions options;

  Asked() {
    tests[0].name = "beam.toml";
    tests[0].parameters = {moves(tests[0], "young"), moves(tests[0], "poisson")};
    targets = targets_of(tests[0], {-1e-3, -1e-4, 1e-5, 1e-6, 1e-3}, 0.01);
  }

  std::vector<Fault> faults() const {
    try {
      calibrate(tests, parameters, targets, options);
    } catch (const InputError& error) {
      return error.faults();
    }
    return {};
  }

  /// The only one.
  std::string fault() const {
    const std::vector<Fault> found = faults();
    EXPECT_THAT(found, SizeIs(1));
    if (found.empty()) return "";
    EXPECT_FALSE(found[0].cure.empty());
    return to_string(found[0]);
  }
};

TEST(CalibrationInput, WhatIsSoundIsTaken) {
  EXPECT_THAT(Asked().faults(), SizeIs(0));
}

TEST(CalibrationInput, TargetsMustBeThereAndBeNumbers) {
  Asked asked;
  asked.targets.clear();
  EXPECT_THAT(asked.fault(), HasSubstr("there are no targets"));
  for (const double wanted : {NAN, INFINITY}) {
    asked = {};
    asked.targets[1].wanted = wanted;
    EXPECT_THAT(asked.fault(), HasSubstr("target middle: wanted = "));
  }
  for (const double tolerance : {0., -1., double(INFINITY)}) {
    asked = {};
    asked.targets[1].tolerance = tolerance;
    EXPECT_THAT(asked.fault(), HasSubstr("target middle: tolerance = "));
  }
  asked = {};
  asked.targets[1].tolerance = NAN;
  EXPECT_THAT(asked.fault(), HasSubstr("some have none: middle"));
  asked = {};
  asked.targets[1].weight = 2;
  EXPECT_THAT(asked.fault(), HasSubstr("target middle: it has a tolerance and a weight"));
  asked = {};
  asked.targets[1].weight = -1;
  EXPECT_THAT(asked.fault(), HasSubstr("weight = -1"));
  asked = {};
  asked.targets.push_back(asked.targets[0]);
  EXPECT_THAT(asked.fault(), HasSubstr("target tip is given twice"));
  asked.targets.back().test = "";  // of every test, that one too
  EXPECT_THAT(asked.fault(), HasSubstr("target tip is given twice"));
}

TEST(CalibrationInput, UnknownNamesAreAnsweredWithTheNearest) {
  Asked asked;
  asked.targets[0].output = "twits";
  EXPECT_THAT(asked.fault(),
              AllOf(HasSubstr("target twits: beam.toml has no output"), HasSubstr("did you mean twist?")));
  asked = {};
  asked.targets[0].test = "team.toml";
  EXPECT_THAT(asked.fault(), AllOf(HasSubstr("no test \"team.toml\""), HasSubstr("did you mean beam.toml?")));
}

TEST(CalibrationInput, BoundsMustHoldTheStartAndHaveALogarithm) {
  const auto with = [](double lower, double upper, double start = not_given) {
    Asked asked;
    asked.parameters[0].lower = lower;
    asked.parameters[0].upper = upper;
    asked.parameters[0].start = start;
    return asked.fault();
  };
  EXPECT_THAT(with(2e9, 1e9),
              HasSubstr("young: the lower bound 2000000000 must be below the upper bound 1000000000"));
  EXPECT_THAT(with(1e9, 1e9), AllOf(HasSubstr("must be below"), HasSubstr("leave out a parameter")));
  EXPECT_THAT(with(NAN, 1e9), HasSubstr("must be finite"));
  EXPECT_THAT(with(1e9, INFINITY), HasSubstr("must be finite"));
  EXPECT_THAT(with(1e9, 2e9), HasSubstr("the start 50000000000 is outside of the bounds"));
  EXPECT_THAT(with(1e9, 2e9, 3e9), HasSubstr("the start 3000000000 is outside of the bounds"));
  EXPECT_THAT(with(1e9, 2e9, 1.5e9 / 0.), HasSubstr("the start inf is outside"));
}

TEST(CalibrationInput, BoundsStayInsideOfTheLaws) {
  Asked asked;
  asked.parameters[1].upper = 0.6;
  EXPECT_THAT(asked.fault(),
              AllOf(HasSubstr("poisson of bonds.0 (timoshenko) of beam.toml must be at most 0.5"),
                    HasSubstr("lower the upper bound to 0.5")));
  asked = {};
  asked.parameters[1].lower = -1;
  EXPECT_THAT(asked.fault(), HasSubstr("must be greater than -1"));
  asked = {};
  asked.parameters[1].logarithmic = true;
  EXPECT_THAT(asked.fault(), HasSubstr("poisson: the lower bound 0 has no logarithm"));
}

TEST(CalibrationInput, ParametersMustBeSomewhereAndOnlyOnce) {
  Asked asked;
  asked.tests[0].parameters[1].clear();
  EXPECT_THAT(asked.fault(), HasSubstr("poisson: no test has this parameter"));
  asked = {};
  asked.tests[0].parameters[1] = asked.tests[0].parameters[0];
  asked.parameters[1] = asked.parameters[0];
  asked.parameters[1].name = "bonds.0.young";
  EXPECT_THAT(asked.fault(),
              HasSubstr("young and bonds.0.young both move the same parameter of bonds.0 of beam.toml"));
  asked = {};
  asked.parameters.clear();
  asked.tests[0].parameters.clear();
  EXPECT_THAT(asked.fault(), HasSubstr("there are no parameters"));
  asked = {};
  asked.tests[0].parameters.pop_back();
  EXPECT_THAT(asked.fault(), HasSubstr("says of 1 parameters what they are in it, there are 2"));
}

TEST(CalibrationInput, AParameterGivenInAnotherWayIsNotMoved) {
  Asked asked;
  asked.tests[0] = cantilever_test("parallel", {{"young", 50e9}, {"kappa", 2.5}});
  asked.tests[0].name = "beam.toml";
  asked.tests[0].parameters = {moves(asked.tests[0], "young"), moves(asked.tests[0], "poisson")};
  EXPECT_THAT(asked.fault(), HasSubstr("poisson of bonds.0 (parallel) of beam.toml is not given there"));
}

TEST(CalibrationInput, SwitchesAndSeedsAreNoNumbers) {
  Asked asked;
  asked.tests[0] = packing_test(
      "edem-v2", {{"normal_stiffness", 1e10}, {"shear_stiffness", 1e10}, {"torque_feedback", 1}});
  asked.tests[0].parameters = {moves(asked.tests[0], "seed")};
  asked.parameters = {{.name = "seed", .lower = 1, .upper = 9}};
  asked.targets = targets_of(asked.tests[0], {1, 1, 1, 1, 1}, 1);
  EXPECT_THAT(asked.fault(), HasSubstr("is no number that can change a little"));
}

TEST(CalibrationInput, ParametersMayNotOutnumberData) {
  Asked asked;
  asked.targets.resize(1);
  EXPECT_THAT(asked.fault(), HasSubstr("2 parameters cannot be found from 1 target"));
  // A target without a test is a datum in each.
  asked.tests.push_back(asked.tests[0]);
  asked.tests[1].name = "other.toml";
  asked.targets[0].test = "";
  EXPECT_THAT(asked.faults(), SizeIs(0));
}

TEST(CalibrationInput, RobustLossesNeedTolerances) {
  Asked asked;
  asked.options.loss = Loss::huber;
  EXPECT_THAT(asked.faults(), SizeIs(0));
  for (CalibrationTarget& target : asked.targets) target.tolerance = not_given;
  EXPECT_THAT(asked.fault(), HasSubstr("a robust loss tells outliers by their tolerances"));
}

TEST(CalibrationInput, EverythingIsSaidAtOnceButNoMoreThanTwenty) {
  Asked asked;
  asked.parameters[0].lower = 2e12;
  asked.targets[0].wanted = NAN;
  asked.targets[1].output = "?";
  asked.options.most_evaluations = 0;
  EXPECT_THAT(asked.faults(), SizeIs(4));
  for (int i = 0; i < 40; ++i)
    asked.targets.push_back({.output = std::to_string(i), .test = "", .wanted = NAN});
  EXPECT_THAT(asked.faults(), SizeIs(21));
}

TEST(CalibrationInput, AMechanismAtTheStartComesOutAsItIs) {
  Asked asked;
  asked.tests[0].model.supports.clear();
  try {
    calibrate(asked.tests, asked.parameters, asked.targets, asked.options);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::mechanism);
  }
}

TEST(CalibrationInput, TestsHaveTheirOwnNames) {
  Asked asked;
  asked.tests.push_back(asked.tests[0]);
  EXPECT_THAT(asked.fault(), HasSubstr("two tests are called \"beam.toml\""));
  asked = {};
  asked.tests.clear();
  EXPECT_GE(asked.faults().size(), 1u);
}

}  // namespace
}  // namespace bondstatic::test
