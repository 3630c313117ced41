#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/error.hpp"
#include "bondstatic/output.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

using testing::HasSubstr;

Output output_of(const std::string& of, std::vector<Index> at,
                 Output::Reduce reduce = Output::Reduce::value) {
  Output output;
  output.name = "it";
  output.of = of;
  output.at = std::move(at);
  output.reduce = reduce;
  return output;
}

double evaluated(const Output& output) {
  const StaticSolution solution{{test::hand_made_result("")}, {}};
  return evaluate_outputs(test::hand_made_model(), solution, {output}).front().value;
}

TEST(Outputs, TakeColumnsOfParticlesAndBonds) {
  EXPECT_EQ(evaluated(output_of("uz", {2})), 0.03);
  EXPECT_EQ(evaluated(output_of("rz", {2})), 0.4);
  EXPECT_EQ(evaluated(output_of("reaction_my", {0})), 1);
  EXPECT_EQ(evaluated(output_of("radius", {1})), 1.5);
  EXPECT_EQ(evaluated(output_of("normal_force", {1})), 5);
  EXPECT_EQ(evaluated(output_of("fz", {0})), -6);
}

TEST(Outputs, MagnitudesAreNorms) {
  EXPECT_DOUBLE_EQ(evaluated(output_of("u", {2})), 0.05);
  EXPECT_DOUBLE_EQ(evaluated(output_of("rotation", {2})), 0.5);
}

TEST(Outputs, EnergyIsTheModelsWithoutAndTheBondsWithASelection) {
  EXPECT_EQ(evaluated(output_of("energy", {})), 0.75);
  EXPECT_EQ(evaluated(output_of("energy", {0})), 0.25);
  EXPECT_EQ(evaluated(output_of("work", {})), 1.5);
}

TEST(Outputs, ReductionsSkipWhatWasLeftOut) {
  EXPECT_EQ(evaluated(output_of("uz", {0, 1, 2, 3}, Output::Reduce::sum)), 0.04);
  EXPECT_DOUBLE_EQ(evaluated(output_of("uz", {0, 1, 2, 3}, Output::Reduce::mean)), 0.04 / 3);
  EXPECT_EQ(evaluated(output_of("uz", {0, 1, 2, 3}, Output::Reduce::max)), 0.03);
  EXPECT_EQ(evaluated(output_of("sigma", {0, 1}, Output::Reduce::max)), 0.1);
  EXPECT_TRUE(std::isnan(evaluated(output_of("uz", {3}, Output::Reduce::sum))));
  EXPECT_TRUE(std::isnan(evaluated(output_of("uz", {3}))));
}

TEST(Outputs, StressAndStiffnessAreThoseOfAPeriodicCell) {
  StaticSolution solution;
  solution.cases.push_back(test::hand_made_result(""));
  solution.cases[0].stress << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  solution.effective.emplace();
  solution.effective->stiffness = Matrix6::Identity() * 7;
  solution.effective->stiffness(0, 2) = 8;
  solution.effective->isotropic = {70, 0.3, 0.01};
  const auto value = [&](const std::string& of) {
    return evaluate_outputs(test::hand_made_model(), solution, {output_of(of, {})}).front().value;
  };
  EXPECT_EQ(value("stress_yz"), 5);
  EXPECT_EQ(value("stress_xx"), 1);
  EXPECT_EQ(value("effective_c44"), 7);
  EXPECT_EQ(value("effective_c13"), 8);
  EXPECT_EQ(value("effective_poisson"), 0.3);
  for (const char* of : {"stress_xx", "effective_young"}) try {
      evaluated(output_of(of, {}));
      ADD_FAILURE() << of;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("periodic cell"));
    }
}

TEST(Outputs, ScaleMultipliesTheValue) {
  Output output = output_of("uz", {2});
  output.scale = -1e3;
  EXPECT_DOUBLE_EQ(evaluated(output), -30);
}

TEST(Outputs, ComeFromTheLoadCaseThatTheyName) {
  LoadCaseResult twice = test::hand_made_result("twice");
  twice.displacement[2] *= 2;
  const StaticSolution solution{{test::hand_made_result("once"), twice}, {}};
  Output output = output_of("uz", {2});
  output.load_case = "twice";
  EXPECT_EQ(evaluate_outputs(test::hand_made_model(), solution, {output}).front().value, 0.06);
  output.load_case = "thrice";
  EXPECT_THROW(evaluate_outputs(test::hand_made_model(), solution, {output}), Error);
}

TEST(Outputs, WithoutOneMeaningAreErrorsThatNameThem) {
  for (const Output& wrong : {output_of("uz", {0, 1}), output_of("uz", {}), output_of("nonsense", {0})}) {
    try {
      evaluated(wrong);
      ADD_FAILURE() << wrong.of;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr("output \"it\""));
      EXPECT_THAT(error.what(), HasSubstr("cure:"));
    }
  }
}

TEST(Outputs, EveryListedQuantityCanBeEvaluated) {
  StaticSolution solution;
  solution.cases.push_back(test::hand_made_result(""));
  solution.cases[0].stress.setIdentity();
  solution.effective.emplace().stiffness.setIdentity();
  Model model = test::hand_made_model();
  for (int p = 0; p < 3; ++p) model.particles[std::size_t(p)].position = Vector3::Unit(p);
  for (const Quantity& quantity : output_quantities()) {
    Output output = output_of(quantity.name, {0});
    output.base = {1};
    output.middle = {0, 1, 2};
    output.axis = Vector3::Ones();
    EXPECT_NO_THROW(evaluate_outputs(model, solution, {output})) << quantity.name;
    EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
  }
}

TEST(OutputValue, RelativeErrorIsRelativeToWhatIsExpected) {
  OutputValue value;
  value.value = 1.1;
  EXPECT_TRUE(std::isnan(value.relative_error()));
  value.expected = -2;
  EXPECT_DOUBLE_EQ(value.relative_error(), 1.55);
  value.expected = 0;
  EXPECT_EQ(value.relative_error(), 1.1);
}

// Base: particle 10 (reaction -6), top: particle 30. H = 4, d = 0.03; the box of the three that are left is
// 3 by 3 (radius 1.5), the left-out one at x = 50 does not widen it: E = 6 4 / (9 0.03).
Output apparent(Index base, Index top, double direction) {
  Output output = output_of("apparent_young", {top});
  output.base = {base};
  output.axis = direction * Vector3::UnitZ();
  return output;
}

TEST(ApparentYoung, IsForceTimesHeightOverAreaTimesShortening) {
  EXPECT_DOUBLE_EQ(evaluated(apparent(0, 2, 1)), 24 / 0.27);
}

TEST(ApparentYoung, DoesNotDependOnTheSenseOfTheAxisOrItsLength) {
  EXPECT_DOUBLE_EQ(evaluated(apparent(0, 2, -7)), 24 / 0.27);
}

TEST(ApparentYoung, IsPositiveInCompressionAsWell) {
  StaticSolution solution{{test::hand_made_result("")}, {}};
  for (Vector6& u : solution.cases[0].displacement) u = -u;
  for (Vector6& reaction : solution.cases[0].reaction) reaction = -reaction;
  EXPECT_DOUBLE_EQ(evaluate_outputs(test::hand_made_model(), solution, {apparent(0, 2, 1)})[0].value,
                   24 / 0.27);
}

TEST(ApparentYoung, LeftOutParticlesOfThePlatensDoNotCount) {
  Output output = apparent(0, 2, 1);
  output.at.push_back(3);
  EXPECT_DOUBLE_EQ(evaluated(output), 24 / 0.27);
  EXPECT_TRUE(std::isnan(evaluated(apparent(0, 3, 1))));
}

}  // namespace
}  // namespace bondstatic
