#include "results/linearise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "bondstatic/error.hpp"
#include "results/changed_answer.hpp"
#include "results/hand_made.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

using Reduce = Output::Reduce;
using testing::HasSubstr;

constexpr Index left_out = 5;

std::vector<Index> all_of(std::size_t count) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index(0));
  return all;
}

Output output_of(const std::string& of, std::vector<Index> at, Reduce reduce = Reduce::value) {
  Output output;
  output.name = "it";
  output.of = of;
  output.at = std::move(at);
  output.reduce = reduce;
  return output;
}

/// Every way to ask for a quantity.
std::vector<Output> ways(const Quantity& quantity, const Model& model) {
  std::vector<Output> outputs;
  if (quantity.where == Quantity::Where::model) {
    outputs.push_back(output_of(quantity.name, {}));
    if (quantity.name.starts_with("apparent_")) {
      outputs.back().at = {26, 23, left_out, 8, 17};
      outputs.back().base = {0, 3, 9};
      outputs.back().axis = Vector3(0.1, -0.2, 1.5);
      outputs.push_back(outputs.back());
      outputs.back().middle = {4, 13, left_out, 22, 10, 1, 25};
      outputs.back().axis = Vector3(-1, 0.2, 0.3);
    }
  } else {
    const bool particles = quantity.where == Quantity::Where::particle;
    const auto all = all_of(particles ? model.particles.size() : model.bonds.size());
    outputs.push_back(output_of(quantity.name, {7}));
    for (const Reduce reduce : {Reduce::sum, Reduce::mean, Reduce::max})
      outputs.push_back(output_of(quantity.name, all, reduce));
    outputs.push_back(output_of(quantity.name, {11, 3, 11}, Reduce::sum));
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    outputs[i].load_case = i % 2 == 0 ? "b" : "a";
    outputs[i].scale = -2.5;
  }
  return outputs;
}

struct WithAnswer {
  std::mt19937_64 random{11};
  const Model model = random_packing(random, 3, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}}));
  const AnswerWithSections answer = random_answer(model, random, left_out),
                           direction = random_answer(model, random, left_out);

  double value(const Output& output, double step) const {
    const StaticSolution there = moved(model, answer, direction, step).solution;
    return evaluate_outputs(model, there, {output}).front().value;
  }
  /// Central difference of sixth order: its error is that of rounding.
  double slope(const Output& output) const {
    constexpr double h = 1e-4;
    const auto apart = [&](double n) { return value(output, n * h) - value(output, -n * h); };
    return (45 * apart(1) - 9 * apart(2) + apart(3)) / (60 * h);
  }
  Change change(const Output& output) const {
    return applied(linearise(output, model, answer.solution, answer.properties), direction);
  }
};

struct Linearise : WithAnswer, testing::TestWithParam<Quantity> {};

TEST_P(Linearise, IsHowTheValueChanges) {
  for (const Output& output : ways(GetParam(), model)) {
    const Change change = this->change(output);
    const double scale = std::max(change.magnitude, std::abs(value(output, 0)));
    EXPECT_NEAR(slope(output), change.value, 1e-10 * scale)
        << output.of << " at " << output.at.size() << ", reduce " << int(output.reduce);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Linearise, testing::ValuesIn(output_quantities()), [](const auto& test) {
  return (test.param.where == Quantity::Where::bond ? "bond_" : "") + test.param.name;
});

struct LinearQuantities : WithAnswer, testing::TestWithParam<Quantity> {};

TEST_P(LinearQuantities, ChangeByAnyStepAsTheFunctionalSays) {
  for (const Output& output : ways(GetParam(), model)) {
    if (output.reduce == Reduce::max) continue;
    const Change change = this->change(output);
    EXPECT_NEAR(value(output, 1) - value(output, 0), change.value,
                16 * 0x1p-53 * (change.magnitude + std::abs(value(output, 0))))
        << output.of;
  }
}

std::vector<Quantity> linear_quantities() {
  std::vector<Quantity> linear;
  for (const Quantity& quantity : output_quantities()) {
    const std::string& of = quantity.name;
    const bool curved = of == "u" || of == "rotation" || of == "shear_force" || of == "bending_moment" ||
                        of == "sigma" || of == "tau" || of == "effective_young" ||
                        of == "effective_poisson" || of == "effective_misfit" || of.starts_with("apparent_");
    if (!curved && !of.starts_with("effective_c")) linear.push_back(quantity);
  }
  return linear;
}

INSTANTIATE_TEST_SUITE_P(Of, LinearQuantities, testing::ValuesIn(linear_quantities()), [](const auto& test) {
  return (test.param.where == Quantity::Where::bond ? "bond_" : "") + test.param.name;
});

struct LinearisedOutput : WithAnswer, testing::Test {};

TEST_F(LinearisedOutput, OfPositionsIsNothing) {
  EXPECT_TRUE(
      linearise(ways(output_quantities()[0], model)[0], model, answer.solution, answer.properties).empty());
}

TEST_F(LinearisedOutput, OfTheLargestIsThatOfTheFirstThatIsAsLarge) {
  StaticSolution solution = answer.solution;
  for (const std::size_t p : {20u, 9u, 14u}) solution.cases[0].displacement[p][1] = 4;
  Output output = output_of("uy", {2, 20, 9, 14}, Reduce::max);
  output.load_case = "a";
  const Functionals found = linearise(output, model, solution, answer.properties);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].displacement.size(), 1u);
  EXPECT_EQ(found[0].displacement[0].first, 20);
  EXPECT_EQ(found[0].displacement[0].second, Vector6(Vector6::Unit(1)));
}

void expect_refusal(const Output& output, const Model& model, const StaticSolution& solution,
                    const std::vector<BondProperties>& properties, const std::string& reason) {
  try {
    linearise(output, model, solution, properties);
    ADD_FAILURE() << output.of << " was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("output \"it\""));
    EXPECT_THAT(error.what(), HasSubstr(reason));
    EXPECT_THAT(error.what(), HasSubstr("cure:"));
  }
}

TEST(LineariseRefuses, WhereThereIsNoDerivative) {
  const Model model = hand_made_model();
  const StaticSolution solution{{hand_made_result("")}, {}};
  const std::vector<BondProperties> properties(2, {{}, 1.0});
  const auto refused = [&](const Output& output, const std::string& reason) {
    expect_refusal(output, model, solution, properties, reason);
  };
  refused(output_of("uz", {3}), "uz is nan");
  refused(output_of("tau", {0}), "tau is nan");
  refused(output_of("nonsense", {0}), "no quantity");
  refused(output_of("stress_xx", {}), "periodic cell");
}

// The hand-made answer: particle 10 is held, 20 and 30 move; bond 1 carries nothing but tension.
TEST(LineariseOf, WhatIsExactlyZeroIsNothing) {
  const Model model = hand_made_model();
  const StaticSolution solution{{hand_made_result("")}, {}};
  const std::vector<BondProperties> properties(2, {{}, 1.0});
  for (const Output& output : {output_of("u", {0}), output_of("rotation", {1})})
    EXPECT_TRUE(linearise(output, model, solution, properties).empty()) << output.of;
  for (const char* of : {"shear_force", "bending_moment"})
    EXPECT_TRUE(linearise(output_of(of, {0}), model, solution, properties).at(0).bonds.at(0).force.isZero(0))
        << of;
  const BondWeight sigma = linearise(output_of("sigma", {0}), model, solution, properties).at(0).bonds.at(0);
  EXPECT_TRUE(sigma.force.tail<3>().isZero(0));
  EXPECT_FALSE(sigma.force.head<3>().isZero(0));
}

// Along an oblique axis a bond in tension has a shear force of nothing but rounding.
TEST(LineariseRefuses, WhatIsZeroButForRounding) {
  Model model = hand_made_model();
  model.bonds[0].branch = Vector3(1, 2, 0.3);
  StaticSolution solution{{hand_made_result("")}, {}};
  BondResult& bond = solution.cases[0].bonds[0];
  bond.force.head<3>() = -6 * model.bonds[0].branch.normalized();
  bond.shear_force = 1e-16;
  expect_refusal(output_of("shear_force", {0}), model, solution, std::vector<BondProperties>(2, {{}, 1.0}),
                 "shear_force has no derivative at bond 1");
}

TEST(LineariseRefuses, TheMisfitOfAnIsotropicStiffness) {
  std::mt19937_64 random(1);
  const Model model = hand_made_model();
  AnswerWithSections answer = random_answer(model, random, 3);
  Matrix6& stiffness = answer.solution.effective->stiffness;
  stiffness.setZero();
  stiffness.topLeftCorner<3, 3>().setConstant(2.0 / 3);
  stiffness.diagonal() << 5.0 / 3, 5.0 / 3, 5.0 / 3, 0.5, 0.5, 0.5;
  answer.solution.effective->isotropic = isotropic_fit(stiffness);
  expect_refusal(output_of("effective_misfit", {}), model, answer.solution, answer.properties,
                 "effective_misfit has no derivative where the stiffness is isotropic");
  EXPECT_EQ(linearise(output_of("effective_young", {}), model, answer.solution, answer.properties).size(),
            6u);
}

}  // namespace
}  // namespace bondstatic::test
