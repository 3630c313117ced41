// Derivatives of outputs to every parameter of every law, against differences of whole solves, and against
// closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "results/linearise.hpp"
#include "results/sensitivities.hpp"
#include "support/models.hpp"
#include "support/ridders.hpp"

namespace bondstatic::test {
namespace {

struct LawCase {
  const char* name;
  const char* law;
  Values values;
  double smallest_radius = 0.3;
};

void PrintTo(const LawCase& chosen, std::ostream* out) {
  *out << chosen.name;
}

const std::vector<LawCase> law_cases{
    {"ParallelKappa", "parallel", {{"young", 5e9}, {"kappa", 2.5}, {"radius_factor", 0.8}}},
    {"ParallelPoisson", "parallel", {{"young", 5e9}, {"poisson", 0.2}, {"radius", 0.25}}},
    {"PfcParallel",
     "pfc-parallel",
     {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}, {"radius_factor", 0.8}}},
    {"PfcDeformability", "pfc-parallel", {{"effective_modulus", 5e9}, {"stiffness_ratio", 2.5}}},
    {"EulerBernoulli", "euler-bernoulli", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.8}}},
    {"Timoshenko", "timoshenko", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.8}}},
    {"Obermayr",
     "obermayr",
     {{"young", 5e9}, {"poisson", 0.2}, {"shear_coefficient", 0.85}, {"radius", 0.2}}},
    {"EdemV2",
     "edem-v2",
     {{"normal_stiffness", 5e9},
      {"shear_stiffness", 2e9},
      {"normal_range", 1e9},
      {"shear_range", 5e8},
      {"torque_feedback", 1}}},
    {"EdemV2WithoutFeedback",
     "edem-v2",
     {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}, {"disk_scale", 0.9}, {"torque_feedback", 0}}},
    {"Contact", "contact", {{"kn", 5e8}, {"ks", 2e8}, {"radius", 0.2}}},
    {"TwoSegment", "two-segment", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.8}}},
    {"ConcaveEnd", "concave-end", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.7}}, 0.1},
    {"Generic", "generic", {{"kn", 5e8}, {"ks", 2e8}, {"kt", 1e7}, {"kb", 2e7}, {"radius", 0.2}}},
};

class SensitivityOfLaw : public ::testing::TestWithParam<LawCase> {};

/// Of particles on two sides, held and free, and of a bond of block 0 in the middle.
std::vector<Output> outputs_of(const Model& model) {
  const Index last = Index(model.particles.size()) - 1;
  std::vector<Index> inner;
  Index bond = Index(model.bonds.size()) / 2;
  while (model.bonds[std::size_t(bond)].block != 0) ++bond;
  for (Index p = 1; p < last; ++p) inner.push_back(p);
  std::vector<Output> outputs;
  const auto add = [&](const char* of, std::vector<Index> at, Output::Reduce reduce = Output::Reduce::value) {
    Output output;
    output.name = output.of = of;
    output.at = std::move(at);
    output.reduce = reduce;
    output.scale = 3;
    outputs.push_back(output);
  };
  add("uy", {last / 3});
  add("ux", inner, Output::Reduce::mean);
  add("rz", {last / 2});
  add("reaction_fy", {0});
  add("reaction_mz", {last});
  add("energy", {});
  for (const char* of :
       {"normal_force", "shear_force", "twisting_moment", "bending_moment", "sigma", "tau", "energy"})
    add(of, {bond});
  return outputs;
}

TEST_P(SensitivityOfLaw, EqualsDifferencesOfSolves) {
  std::mt19937_64 random(7);
  const LawCase& chosen = GetParam();
  Model model = random_packing(random, 3, block(chosen.law, chosen.values), chosen.smallest_radius);
  const Index last = Index(model.particles.size()) - 1;
  fix_all(model, 0);
  model.supports.push_back(
      {last, {false, true, false, false, false, true}, vector6(0, 1e-4, 0, 0, 0, 2e-4), every_case});
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Index p = 1; p < last; ++p)
    load(model, p,
         1e3 * vector6(unit(random), unit(random), unit(random), unit(random), unit(random), unit(random)));
  const std::vector<Output> outputs = outputs_of(model);

  StaticAnalysis analysis(model, {});
  const StaticSolution solution = analysis.solve();
  std::vector<OutputValue> values = evaluate_outputs(model, solution, outputs);
  const auto warnings = add_sensitivities(values, outputs, model, solution, analysis, false, 1);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  std::size_t compared = 0;
  for (const BlockParameter& to : differentiable_parameters(model)) {
    if (to.block != 0) continue;
    double& parameter = model.blocks[0].parameters[to.parameter];
    const double here = parameter;
    std::map<double, std::vector<OutputValue>> solved;  // all outputs ask for the same
    for (std::size_t o = 0; o < outputs.size(); ++o) {
      if (values[o].sensitivities.empty() || values[o].value == 0) continue;
      const auto value = [&](double changed) {
        parameter = changed;
        const auto known = solved.find(changed);
        if (known != solved.end()) return known->second[o].value;
        solved[changed] = evaluate_outputs(model, analysis.solve(), outputs);
        return solved[changed][o].value;
      };
      const std::string& name = find_bond_law(chosen.law)->parameters[to.parameter].name;
      const auto found = std::find_if(values[o].sensitivities.begin(), values[o].sensitivities.end(),
                                      [&](const auto& s) { return s.block == 0 && s.parameter == name; });
      ASSERT_NE(found, values[o].sensitivities.end()) << name;
      // What a parameter hardly acts on is a difference of nearly equal values: relative to value / parameter
      // then.
      const double expected = ridders(value, here, 0.1 * here).value;
      EXPECT_NEAR(found->derivative, expected,
                  1e-8 * std::abs(expected) + 1e-12 * std::abs(values[o].value / here))
          << outputs[o].name << " by " << name;
      EXPECT_NEAR(found->elasticity, found->derivative * here / values[o].value,
                  1e-13 * std::abs(found->elasticity));
      ++compared;
    }
    parameter = here;
  }
  EXPECT_GE(compared, 2 * (outputs.size() - 3));
}

INSTANTIATE_TEST_SUITE_P(Verification, SensitivityOfLaw, ::testing::ValuesIn(law_cases),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

Output displacement(const char* of, Index particle) {
  Output output;
  output.name = output.of = of;
  output.at = {particle};
  return output;
}

TEST(Sensitivity, OfDisplacementsToOneModulusIsMinusTheDisplacementOverIt) {
  std::mt19937_64 random(8);
  const double young = 5e9;
  Model model = random_packing(
      random, 4, block("timoshenko", {{"young", young}, {"poisson", 0.2}, {"radius_factor", 0.7}}));
  fix_all(model, 0);
  for (Index p = 1; p < Index(model.particles.size()); ++p) load(model, p, vector6(1, 2, 3, 0.1, 0, 0.2));
  std::vector<Output> outputs;
  for (const char* of : {"ux", "uy", "uz", "rx", "ry", "rz"})
    for (const Index p : {5, 20, 63}) outputs.push_back(displacement(of, p));
  StaticAnalysis analysis(model, {});
  const StaticSolution solution = analysis.solve();
  std::vector<OutputValue> values = evaluate_outputs(model, solution, outputs);
  add_sensitivities(values, outputs, model, solution, analysis, true, 1);
  for (const OutputValue& value : values) {
    const ParameterSensitivity& to_young = value.sensitivities.front();
    ASSERT_EQ(to_young.parameter, "young");
    EXPECT_NEAR(to_young.derivative, -value.value / young, 1e-14 * std::abs(value.value / young));
    EXPECT_NEAR(to_young.elasticity, -1, 1e-14);
    double sum = 0;
    for (const double of_bond : to_young.of_bond) sum += of_bond;
    EXPECT_NEAR(sum, to_young.derivative, 1e-13 * std::abs(to_young.derivative));
  }
}

TEST(Sensitivity, OfTheCantileversTipToYoungPoissonAndRadius) {
  // w = F L^3 / 3EI + 10/9 F L / GA, I = pi r^4 / 4, G = E / 2(1 + nu) ([Chen2022] Eq. 29).
  const double young = 2e11, poisson = 0.3, r = 0.2, length = 4, force = 1e5, pi = std::acos(-1.0);
  Model model = chain(block("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", r}}), {0, 0, 0},
                      {length, 0, 0}, 10, 0.2);
  load(model, 10, vector6(0, force, 0));
  const std::vector<Output> outputs{displacement("uy", 10)};
  StaticAnalysis analysis(model, {});
  const StaticSolution solution = analysis.solve();
  std::vector<OutputValue> values = evaluate_outputs(model, solution, outputs);
  add_sensitivities(values, outputs, model, solution, analysis, false, 1);
  const double bending = 4 * force * std::pow(length, 3) / (3 * young * pi * std::pow(r, 4));
  const double shear = 20 * force * length * (1 + poisson) / (9 * young * pi * r * r);
  const std::map<std::string, double> expected{{"young", -(bending + shear) / young},
                                               {"poisson", shear / (1 + poisson)},
                                               {"radius", (-4 * bending - 2 * shear) / r}};
  ASSERT_EQ(values[0].sensitivities.size(), expected.size());
  for (const ParameterSensitivity& to : values[0].sensitivities)
    EXPECT_NEAR(to.derivative, expected.at(to.parameter), 1e-13 * std::abs(expected.at(to.parameter)))
        << to.parameter;
}

}  // namespace
}  // namespace bondstatic::test
