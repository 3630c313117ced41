// Calibration of models: parameters that are known are found again, and what tests cannot tell is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bondstatic/calibration.hpp"
#include "bondstatic/error.hpp"
#include "calibration/coverage.hpp"
#include "calibration/tests_of_models.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class KnownParameters : public testing::TestWithParam<Known> {};

TEST_P(KnownParameters, AreFoundAgainFromSyntheticTargets) {
  const Known known = GetParam();
  const CalibrationTest test = known.test(known.start);
  const std::vector<double> truth = outputs_of(known.test(known.truth));
  const CalibrationResult found = calibrate({test}, known.parameters(), targets_of(test, truth, 1e-3));
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(found.reached);
  EXPECT_EQ(found.reason, "every target is met within its tolerance");
  EXPECT_THAT(found.unidentified, IsEmpty());
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_NEAR(found.parameters[p].value / known.truth[p], 1, 1e-8) << known.names[p];
    EXPECT_LT(found.parameters[p].lower_95, known.truth[p]);
    EXPECT_GT(found.parameters[p].upper_95, known.truth[p]);
    EXPECT_FALSE(found.parameters[p].at_bound);
  }
  for (const AchievedTarget& target : found.targets)
    EXPECT_NEAR(target.achieved, target.wanted, 1e-10 * std::abs(target.wanted));
  EXPECT_LT(found.solves, 10);
  RecordProperty("solves", found.solves);
}

TEST_P(KnownParameters, AreInsideOfTheirIntervalsInNinetyFivePerCentOfNoisyTrials) {
  const Known known = GetParam();
  const CalibrationTest test = known.test(known.truth);
  const std::vector<double> truth = outputs_of(test);
  const int trials = coverage_trials(25);
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const bool tolerances : {true, false}) {
    std::vector<int> inside(2);
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> measured = truth;
      for (double& value : measured) value *= 1 + 0.003 * normal(random);
      const CalibrationResult found =
          calibrate({test}, known.parameters(), targets_of(test, measured, tolerances ? 0.003 : not_given));
      ASSERT_TRUE(found.converged) << found.reason;
      for (std::size_t p = 0; p < 2; ++p)
        inside[p] +=
            found.parameters[p].lower_95 <= known.truth[p] && found.parameters[p].upper_95 >= known.truth[p];
    }
    for (std::size_t p = 0; p < 2; ++p) {
      SCOPED_TRACE(known.names[p] + (tolerances ? " with tolerances" : " without"));
      expect_coverage(inside[p], trials);
      RecordProperty(known.names[p] + (tolerances ? "_known" : "_t"), inside[p]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, KnownParameters, testing::ValuesIn(known_parameters()),
                         [](const auto& law) { return law.param.name; });

CalibrationParameter parameter(const std::string& name, double lower, double upper, bool logarithmic = true) {
  return {.name = name, .lower = lower, .upper = upper, .logarithmic = logarithmic};
}

TEST(Calibrate, YoungAndRadiusOfASlenderBeamActThroughAProduct) {
  CalibrationTest test =
      cantilever_test("euler-bernoulli", {{"young", 70e9}, {"poisson", 0.2}, {"radius_factor", 0.5}}, true);
  test.parameters = {moves(test, "young"), moves(test, "radius_factor")};
  const CalibrationTarget tip{.output = "tip", .test = "", .wanted = -3e-3, .tolerance = 1e-5};
  const CalibrationTarget middle{.output = "middle", .test = "", .wanted = -0.94e-3, .tolerance = 1e-5};
  const CalibrationResult found =
      calibrate({test}, {parameter("young", 1e9, 1e12), parameter("radius_factor", 0.1, 1)}, {tip, middle});
  ASSERT_THAT(found.unidentified, SizeIs(1));
  EXPECT_EQ(found.unidentified[0].sentence,
            "young and radius_factor act only through young radius_factor^4 in these tests");
  EXPECT_NEAR(std::abs(found.unidentified[0].direction[0] / found.unidentified[0].direction[1]), 4, 1e-9);
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(found.reached) << found.reason;
  for (const CalibratedParameter& one : found.parameters) {
    EXPECT_TRUE(std::isnan(one.lower_95));
    EXPECT_TRUE(std::isnan(one.upper_95));
  }
  EXPECT_TRUE(found.correlation.array().isNaN().all());
  EXPECT_LT(found.singular_values[1], 1e-8 * found.singular_values[0]);
}

TEST(Calibrate, StretchedBarsTellTheProductWithTheSectionAlone) {
  CalibrationTest test =
      cantilever_test("timoshenko", {{"young", 70e9}, {"poisson", 0.2}, {"radius_factor", 0.5}}, true);
  test.parameters = {moves(test, "young"), moves(test, "radius_factor"), moves(test, "poisson")};
  const double stretch = outputs_of(test)[2];
  const std::vector<CalibrationTarget> targets{
      {.output = "stretch", .test = "", .wanted = 1.1 * stretch, .tolerance = 0.01 * stretch},
      {.output = "half_stretch", .test = "", .wanted = 0.55 * stretch, .tolerance = 0.01 * stretch},
      {.output = "pull", .test = "", .wanted = 1, .tolerance = 0.01}};
  const CalibrationResult found =
      calibrate({test},
                {parameter("young", 1e9, 1e12), parameter("radius_factor", 0.1, 1),
                 parameter("poisson", 0, 0.5, false)},
                targets);
  ASSERT_THAT(found.unidentified, SizeIs(2));
  EXPECT_EQ(found.unidentified[0].sentence,
            "young and radius_factor act only through young radius_factor^2 in these tests");
  EXPECT_EQ(found.unidentified[1].sentence, "poisson has no influence on any target");
  EXPECT_EQ(found.parameters[2].value, 0.2);
}

// Twist asks for more shear than nu = 0.5 gives.
TEST(Calibrate, WhatIsOutOfReachNamesTheBound) {
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 70e9}, {"poisson", 0.2}});
  test.parameters = {moves(test, "young"), moves(test, "poisson")};
  CalibrationTest at_bound = cantilever_test("timoshenko", {{"young", 70e9}, {"poisson", 0.5}});
  std::vector<double> wanted = outputs_of(at_bound);
  wanted[4] *= 1.05;
  const CalibrationResult found =
      calibrate({test}, {parameter("young", 1e9, 1e12), parameter("poisson", 0, 0.5, false)},
                targets_of(test, wanted, 1e-3));
  EXPECT_TRUE(found.converged);
  EXPECT_FALSE(found.reached);
  EXPECT_TRUE(found.parameters[1].at_bound);
  EXPECT_EQ(found.parameters[1].value, 0.5);
  EXPECT_FALSE(found.parameters[0].at_bound);
  EXPECT_TRUE(std::isnan(found.parameters[1].upper_95));
  EXPECT_FALSE(std::isnan(found.parameters[0].upper_95));
  EXPECT_THAT(
      found.reason,
      AllOf(
          HasSubstr("poisson is at its upper bound 0.5; what is wanted is out of reach, this is the nearest"),
          HasSubstr("twist is "), HasSubstr("instead of "), HasSubstr("tolerances")));
}

// What is achieved is known as well where it is nothing beside what is wanted.
TEST(Calibrate, AchievedIsWhatTheModelSays) {
  const Values soft{{"young", 1e9}, {"poisson", 0.2}};
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 70e9}, {"poisson", 0.2}});
  test.parameters = {moves(test, "young")};
  const double tip = outputs_of(cantilever_test("timoshenko", soft))[0];
  const CalibrationResult found = calibrate({test}, {parameter("young", 1e9, 1e12)},
                                            {{.output = "tip", .test = "", .wanted = 1e12 * tip}});
  EXPECT_TRUE(found.parameters[0].at_bound);
  EXPECT_NEAR(found.targets[0].achieved / tip, 1, 1e-13);
}

// Intervals from tolerances are none where the model itself is wrong by much more.
TEST(Calibrate, IntervalsThatMisfitBeliesAreSaidToBeTooNarrow) {
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 70e9}, {"poisson", 0.2}});
  test.parameters = {moves(test, "young")};
  std::vector<double> wanted = outputs_of(test);
  const std::vector<CalibrationParameter> young{parameter("young", 1e9, 1e12)};
  EXPECT_THAT(calibrate({test}, young, targets_of(test, wanted, 1e-3)).warnings, IsEmpty());
  wanted[4] *= 1.05;
  const CalibrationResult found = calibrate({test}, young, targets_of(test, wanted, 1e-3));
  EXPECT_TRUE(found.converged);
  ASSERT_THAT(found.warnings, SizeIs(1));
  EXPECT_THAT(found.warnings[0], HasSubstr("95 % intervals rest on: these are too narrow"));
}

TEST(Calibrate, SeveralTestsShareTheirParameters) {
  // Two cantilevers, one of bonds twice as long; the second alone has kappa.
  CalibrationTest first = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  CalibrationTest second = cantilever_test("parallel", {{"young", 50e9}, {"kappa", 2}});
  first.name = "first.toml";
  second.name = "second.toml";
  first.parameters = {moves(first, "young"), {}};
  second.parameters = {moves(second, "young"), moves(second, "kappa")};
  std::vector<CalibrationTarget> targets;
  for (const CalibrationTest* test : {&first, &second}) {
    CalibrationTest truth = *test;
    truth.model.blocks[0].parameters[test->parameters[0][0].parameter] = 80e9;
    if (!test->parameters[1].empty())
      truth.model.blocks[0].parameters[test->parameters[1][0].parameter] = 3.5;
    for (const CalibrationTarget& target : targets_of(*test, outputs_of(truth), not_given))
      targets.push_back(target);
  }
  const CalibrationResult found =
      calibrate({first, second}, {parameter("young", 1e9, 1e12), parameter("kappa", 0.5, 10)}, targets);
  EXPECT_TRUE(found.reached);
  EXPECT_EQ(found.reason, "every target is met");
  EXPECT_NEAR(found.parameters[0].value, 80e9, 80);
  EXPECT_NEAR(found.parameters[1].value, 3.5, 3.5e-8);
  EXPECT_EQ(found.targets[0].test, "first.toml");
  EXPECT_EQ(found.solves, 2 * int(found.history.size()));
}

TEST(Calibrate, AMemoryLimitHoldsForTheFactorsOfAllTests) {
  CalibrationTest first = packing_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  first.parameters = {moves(first, "young")};
  first.name = "first.toml";
  first.solve.solver = "eigen";
  CalibrationTest second = first;
  second.name = "second.toml";
  const StaticSolution alone = solve_statics(first.model, first.solve);
  const auto calibrated_within = [&](double limit) {
    first.solve.memory_limit = second.solve.memory_limit = limit * alone.report.analysis.predicted_bytes;
    return calibrate({first, second}, {parameter("young", 1e9, 1e12)},
                     {{.output = "press", .test = "", .wanted = 2 * outputs_of(first)[0]}});
  };
  EXPECT_TRUE(calibrated_within(2.01).reached);
  try {
    calibrated_within(1.99);
    ADD_FAILURE();
  } catch (const MemoryError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("second.toml, with "), HasSubstr(" for the tests before it")));
  }
}

TEST(Calibrate, ATargetWithoutATestCountsInEachThatHasItsOutput) {
  CalibrationTest first = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  CalibrationTest second = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.1}});
  first.name = "first.toml";
  second.name = "second.toml";
  for (CalibrationTest* test : {&first, &second}) test->parameters = {moves(*test, "young")};
  const CalibrationResult found =
      calibrate({first, second}, {parameter("young", 1e9, 1e12)},
                {{.output = "tip", .test = "", .wanted = 2 * outputs_of(first)[0]}});
  ASSERT_THAT(found.targets, SizeIs(2));
  EXPECT_EQ(found.targets[1].test, "second.toml");
  EXPECT_FALSE(found.reached);
  EXPECT_TRUE(found.converged);
  // One parameter, two data: one degree of freedom tells the size of errors.
  EXPECT_TRUE(std::isfinite(found.parameters[0].upper_95));
}

TEST(Calibrate, HistoryTellsEachEvaluation) {
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  test.parameters = {moves(test, "young")};
  CalibrationOptions options;
  std::vector<double> costs;
  options.progress = [&](int evaluation, double cost) {
    costs.push_back(cost);
    EXPECT_EQ(evaluation, int(costs.size()));
  };
  const CalibrationResult found =
      calibrate({test}, {parameter("young", 1e9, 1e12)},
                {{.output = "tip", .test = "", .wanted = 3 * outputs_of(test)[0]}}, options);
  ASSERT_EQ(found.history.size(), costs.size());
  EXPECT_EQ(found.history[0].parameters[0], 50e9);
  EXPECT_TRUE(found.history[0].accepted);
  EXPECT_NEAR(costs[0], 0.5 * 4. / 9, 1e-12);
  EXPECT_NEAR(found.parameters[0].value, 50e9 / 3, 1);
  for (std::size_t i = 0; i < costs.size(); ++i) EXPECT_EQ(found.history[i].cost, costs[i]);
}

TEST(Calibrate, ProgressMayGiveUpAtAnyTime) {
  struct GivenUp {};
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  test.parameters = {moves(test, "young")};
  for (int when = 1; when <= 4; ++when) {
    CalibrationOptions options;
    options.progress = [&](int evaluation, double) {
      if (evaluation == when) throw GivenUp{};
    };
    EXPECT_THROW(calibrate({test}, {parameter("young", 1e9, 1e12)},
                           {{.output = "tip", .test = "", .wanted = 3 * outputs_of(test)[0]}}, options),
                 GivenUp);
  }
}

TEST(Calibrate, InterruptedSolvesComeOut) {
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  test.parameters = {moves(test, "young")};
  const double tip = outputs_of(test)[0];
  int phases = 0;
  test.solve.progress = [&](const std::string&) {
    if (++phases == 25) throw Error(ExitCode::interrupted, "interrupted");
  };
  try {
    calibrate({test}, {parameter("young", 1e9, 1e12)}, {{.output = "tip", .test = "", .wanted = 3 * tip}});
    ADD_FAILURE() << "phases: " << phases;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
  }
}

TEST(Calibrate, TooFewEvaluationsAreSaid) {
  CalibrationTest test = cantilever_test("timoshenko", {{"young", 50e9}, {"poisson", 0.3}});
  test.parameters = {moves(test, "young")};
  CalibrationOptions options;
  options.most_evaluations = 2;
  const CalibrationResult found =
      calibrate({test}, {parameter("young", 1e9, 1e12)},
                {{.output = "tip", .test = "", .wanted = 30 * outputs_of(test)[0]}}, options);
  EXPECT_FALSE(found.converged);
  EXPECT_FALSE(found.reached);
  EXPECT_THAT(
      found.reason,
      HasSubstr("stopped after 2 evaluations, before a minimum was found; 1 of 1 target is missed: tip is"));
}

// EDEM's scatter must stay smaller than the stiffness: below 4e9 the law has no answer.
TEST(Calibrate, WhereSolvesFailStepsAreShortenedAndTheReasonSaysSo) {
  CalibrationTest test = packing_test(
      "edem-v2",
      {{"normal_stiffness", 1e10}, {"shear_stiffness", 5e9}, {"normal_range", 4e9}, {"torque_feedback", 1}});
  test.parameters = {moves(test, "normal_stiffness"), moves(test, "shear_stiffness")};
  const std::vector<double> now = outputs_of(test);
  const std::vector<CalibrationParameter> parameters{parameter("normal_stiffness", 1e8, 1e13),
                                                     parameter("shear_stiffness", 1e8, 1e13)};
  const auto times = [&](double factor) {
    std::vector<double> wanted = now;
    for (double& value : wanted) value *= factor;
    return targets_of(test, wanted, 1e-3);
  };
  const CalibrationResult near = calibrate({test}, parameters, times(0.6));
  EXPECT_TRUE(near.converged) << near.reason;

  const CalibrationResult beyond = calibrate({test}, parameters, times(0.1));
  EXPECT_FALSE(beyond.converged);
  EXPECT_THAT(beyond.reason, HasSubstr("normal_range = 4000000000: must be smaller than normal_stiffness"));
  EXPECT_GT(beyond.parameters[0].value, 4e9);
  bool failed = false;
  for (const CalibrationStep& step : beyond.history) {
    failed = failed || std::isnan(step.cost);
    EXPECT_FALSE(std::isnan(step.cost) && step.accepted);
  }
  EXPECT_TRUE(failed);
}

TEST(Calibrate, AnOutlierIsLeftToARobustLoss) {
  const Known known = known_parameters().front();
  const CalibrationTest test = known.test(known.start);
  std::vector<double> measured = outputs_of(known.test(known.truth));
  measured[1] *= 1.5;
  CalibrationOptions options;
  options.loss = Loss::cauchy;
  const auto targets = targets_of(test, measured, 1e-3);
  const CalibrationResult robust = calibrate({test}, known.parameters(), targets, options);
  const CalibrationResult squares = calibrate({test}, known.parameters(), targets);
  EXPECT_NEAR(robust.parameters[0].value / known.truth[0], 1, 2e-3);
  EXPECT_GT(std::abs(squares.parameters[0].value / known.truth[0] - 1), 1e-2);
}

}  // namespace
}  // namespace bondstatic::test
