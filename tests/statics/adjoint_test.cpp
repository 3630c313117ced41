// Derivatives to the bonds' stiffness numbers by the adjoint method, against differences of whole solves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

#include "bondstatic/sensitivity.hpp"
#include "support/models.hpp"
#include "support/periodic.hpp"
#include "support/ridders.hpp"

namespace bondstatic::test {
namespace {

constexpr std::size_t numbers = 4;  // kn, ks, kt, kb: parameters 0 ... 3 of law generic

/// A packing whose bonds have stiffness of their own, over two decades, each with a section for stresses.
Model scattered_packing(std::uint64_t seed, int edge = 3) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> decades(-1, 1);
  BondBlock generic = block("generic", {{"kn", 1e6}, {"ks", 4e5}, {"kt", 2e4}, {"kb", 3e4}, {"radius", 0.2}});
  generic.contact_point = {ContactPoint::Kind::gap, 0};
  Model model = random_packing(random, edge, generic);
  for (std::size_t p = 0; p < numbers; ++p) {
    std::vector<double>& own = model.blocks[0].overrides[p];
    for (const Bond& bond : model.bonds)
      if (bond.block == 0) own.push_back(model.blocks[0].parameters[p] * std::pow(10, decades(random)));
  }
  fix_all(model, 0, vector6(1e-4, 0, 2e-4, 0, 1e-4, 0));
  model.supports.push_back({5, {true, false, true, false, false, true}, vector6(0, 0, -1e-3), every_case});
  const Index last = Index(model.particles.size()) - 1;
  load(model, last, vector6(10, -20, 30, 1, 2, 3));
  load(model, last / 2, vector6(-5, 4, 0, 0, 1, 0));
  return model;
}

double& number_of(Model& model, const Bond& bond, std::size_t parameter) {
  return model.blocks[0].overrides.at(parameter)[std::size_t(bond.in_block)];
}

double gradient_to(const BondGradient& gradient, std::size_t parameter) {
  const SectionStiffness& c = gradient.stiffness;
  return std::array{c.kn, c.ks, c.kt, c.kb}[parameter];
}

struct Scalar {
  const char* name;
  std::function<double(const State&)> value;
  Functional functional;
};

/// Of some bonds and all four numbers, relative to the largest of all.
void expect_gradients(Model model, const std::vector<Scalar>& scalars, std::size_t bonds, double tolerance) {
  StaticAnalysis analysis(model, {});
  analysis.solve();
  std::vector<Functionals> functionals;
  for (const Scalar& scalar : scalars) functionals.push_back({scalar.functional});
  const std::vector<BondGradients> gradients = analysis.gradients(functionals);
  for (std::size_t k = 0; k < model.bonds.size(); k += model.bonds.size() / bonds)
    for (std::size_t p = 0; p < numbers; ++p) {
      double& c = number_of(model, model.bonds[k], p);
      const double c0 = c;
      std::map<double, StaticSolution> solved;  // all scalars ask for the same
      const auto solution = [&](double changed) -> const StaticSolution& {
        c = changed;
        const auto known = solved.find(changed);
        return known != solved.end() ? known->second : solved[changed] = analysis.solve();
      };
      for (std::size_t s = 0; s < scalars.size(); ++s) {
        const auto load_case = std::size_t(scalars[s].functional.load_case);
        const auto value = [&](double changed) {
          return scalars[s].value(solution(changed).cases[load_case]);
        };
        double largest = 0;
        for (const BondGradient& g : gradients[s]) largest = std::max(largest, std::abs(gradient_to(g, p)));
        EXPECT_NEAR(gradient_to(gradients[s][k], p), ridders(value, c0, 0.3 * c0).value, tolerance * largest)
            << scalars[s].name << ", bond " << model.bonds[k].id << ", number " << p;
      }
      c = c0;
    }
}

std::vector<Scalar> scalars_of(const Model& model) {
  const auto particle = model.particles.size() / 3;
  const std::size_t bond = model.bonds.size() / 2;
  Vector6 weights = vector6(1, -2, 0.5, 0.3, 0.2, -0.7);
  Scalar displaced{"displacement", [=](const State& s) { return weights.dot(s.displacement[particle]); }, {}};
  displaced.functional.displacement = {{Index(particle), weights}};
  Scalar reacting{"reaction", [=](const State& s) { return weights.dot(s.reaction[0] + s.reaction[5]); }, {}};
  reacting.functional.reaction = {{0, weights}, {5, weights}};
  Scalar force{"bond force", [=](const State& s) { return weights.dot(s.bonds[bond].force); }, {}};
  force.functional.bonds = {{.bond = Index(bond), .force = weights}};
  Scalar energy{"energy", [](const State& s) { return s.energy; }, {}};
  energy.functional.energy = 1;
  Scalar of_bond{"energy of a bond", [=](const State& s) { return s.bonds[bond].energy; }, {}};
  of_bond.functional.bonds = {{.bond = Index(bond), .energy = 1}};
  return {displaced, reacting, force, energy, of_bond};
}

TEST(Adjoint, GradientsEqualDifferencesOfSolves) {
  const Model model = scattered_packing(1);
  expect_gradients(model, scalars_of(model), 3, 1e-9);
}

TEST(Adjoint, SeveralLoadCasesWithSupportsOfTheirOwn) {
  Model model = scattered_packing(2);
  model.load_cases = {"held", "freer"};
  model.supports.push_back({9, {true, true, true, false, false, false}, vector6(1e-3, 0, 0), 0});
  std::vector<Scalar> scalars = scalars_of(model);
  for (Scalar& scalar : scalars_of(model)) {
    scalar.functional.load_case = 1;
    scalars.push_back(scalar);
  }
  expect_gradients(model, scalars, 2, 1e-9);
}

TEST(Adjoint, StressOfAPeriodicCell) {
  std::mt19937_64 random(3);
  Model model =
      periodic_packing(random, 3, block("generic", {{"kn", 1e6}, {"ks", 4e5}, {"kt", 2e4}, {"kb", 3e4}}));
  std::uniform_real_distribution<double> factor(0.3, 3);
  for (std::size_t p = 0; p < numbers; ++p)
    for (std::size_t k = 0; k < model.bonds.size(); ++k)
      model.blocks[0].overrides[p].push_back(model.blocks[0].parameters[p] * factor(random));
  Matrix3 weights;
  weights << 1, 0.5, -0.2, 0.1, 2, 0.3, 0.4, -0.6, 0.7;
  std::vector<Scalar> scalars;
  for (const Index load_case : {0, 3}) {
    Scalar stress{"stress", [=](const State& s) { return weights.cwiseProduct(s.stress).sum(); }, {}};
    stress.functional.load_case = load_case;
    stress.functional.stress = weights;
    Scalar energy{"energy", [](const State& s) { return s.energy; }, {}};
    energy.functional.load_case = load_case;
    energy.functional.energy = 1;
    scalars.insert(scalars.end(), {stress, energy});
  }
  expect_gradients(model, scalars, 3, 1e-9);
}

TEST(Adjoint, EnergyUnderLoadsIsMinusItsOwnGradient) {
  // Loads alone, nothing moved: U = f . u / 2, dU/dc = -(delta . dC/dc delta) / 2, and kn dU/dkn + ... = -U
  // in all.
  Model model = scattered_packing(4);
  for (Support& support : model.supports) support.value.setZero();
  StaticAnalysis analysis(model, {});
  const StaticSolution solution = analysis.solve();
  Functional energy;
  energy.energy = 1;
  const BondGradients gradient = analysis.gradients({{energy}}).front();
  double sum = 0;
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const SectionStiffness& c = analysis.properties()[k].stiffness;
    const SectionStiffness& g = gradient[k].stiffness;
    const double own = c.kn * g.kn + c.ks * g.ks + c.kt * g.kt + c.kb * g.kb;
    EXPECT_NEAR(own, -solution.cases[0].bonds[k].energy, 1e-14 * solution.cases[0].energy);
    sum += own;
  }
  EXPECT_NEAR(sum, -solution.cases[0].energy, 1e-14 * solution.cases[0].energy);
}

TEST(Adjoint, LongChainsToRounding) {
  // The root bond of a cantilever carries F, whatever its stiffness; the tip moves by F/k of each bond in
  // tension.
  const Index bonds = 2000;
  Model model = chain(block("generic", {{"kn", 3e5}, {"ks", 1e5}, {"kt", 1e4}, {"kb", 1e4}}), {0, 0, 0},
                      {0.6 * double(bonds), 0, 0.8 * double(bonds)}, bonds, 0.5);
  load(model, bonds, vector6(0.6, 0, 0.8));
  StaticAnalysis analysis(model, {});
  analysis.solve();
  Functional tip, shear;
  tip.displacement = {{bonds, vector6(0.6, 0, 0.8)}};
  shear.bonds = {{.bond = bonds / 2, .force = vector6(0.8, 1, -0.6, 0, 1, 0)}};
  const auto gradients = analysis.gradients({{tip}, {shear}});
  for (const std::size_t k : {0, 700, 1999}) {
    EXPECT_NEAR(gradients[0][k].stiffness.kn, -1 / (3e5 * 3e5), 1e-15 / (3e5 * 3e5)) << k;
    EXPECT_NEAR(gradients[1][k].stiffness.kn, 0, 1e-15 / 3e5) << k;
    EXPECT_NEAR(gradients[1][k].stiffness.kb, 0, 1e-15 / 1e4) << k;
  }
}

TEST(StaticAnalysis, GoesOnWithOtherNumbersAsIfItBeganWithThem) {
  Model model = scattered_packing(5);
  StaticAnalysis analysis(model, {});
  analysis.solve();
  model.blocks[0].overrides.at(1)[3] *= 2;
  model.loads[0].force *= 1.5;
  model.supports[0].value[2] = 3e-4;
  const StaticSolution again = analysis.solve(), fresh = solve_statics(model, {});
  EXPECT_EQ(again.cases[0].displacement, fresh.cases[0].displacement);
  EXPECT_EQ(again.cases[0].reaction, fresh.cases[0].reaction);
  EXPECT_EQ(again.cases[0].energy, fresh.cases[0].energy);
  for (const Phase& phase : again.report.phases)
    EXPECT_TRUE(phase.name != "analysis" && phase.name != "mechanisms") << phase.name;
}

/// A packing whose platen is pressed down, as in a test of a rock.
Model pressed_packing(double young, double poisson) {
  std::mt19937_64 random(12);
  constexpr int edge = 7;
  Model model = random_packing(random, edge, block("timoshenko", {{"young", young}, {"poisson", poisson}}));
  const Index particles = Index(model.particles.size()), layer = edge * edge;
  for (Index p = 0; p < layer; ++p) {
    fix_all(model, p);
    fix_all(model, particles - 1 - p, vector6(0, 0, -1e-3, 0, 0, 0));
  }
  return model;
}

StaticOptions direct() {
  StaticOptions options;
  options.solver = available_solvers().front().name;
  return options;
}

Functional reaction_of_layer(const Model& model, bool top) {
  Functional reaction;
  constexpr Index layer = 49;
  const Index particles = Index(model.particles.size());
  for (Index p = 0; p < layer; ++p)
    reaction.reaction.emplace_back(top ? particles - 1 - p : p, vector6(0, 0, 2.5, 0, 0, 0));
  return reaction;
}

TEST(StaticAnalysis, NumbersCloseByAreAnsweredOnTheFactorThatIsThere) {
  for (const double young : {5e9, 7e9})
    for (const double poisson : {0.2, 0.2 + 1e-7}) {
      Model model = pressed_packing(5e9, 0.2);
      StaticAnalysis analysis(model, direct());
      EXPECT_EQ(analysis.solve().report.factorisations, 1);
      model.blocks[0].parameters[0] = young, model.blocks[0].parameters[1] = poisson;
      const StaticSolution again = analysis.solve(), fresh = solve_statics(model, direct());
      EXPECT_EQ(again.report.factorisations, 0);
      EXPECT_NE(again.report.solver_reason.find("on the factor of an earlier solve"), std::string::npos);
      EXPECT_GT(again.report.iterations, 0);
      EXPECT_EQ(again.cases[0].displacement, fresh.cases[0].displacement);
      EXPECT_EQ(again.cases[0].reaction, fresh.cases[0].reaction);
      EXPECT_EQ(again.cases[0].energy, fresh.cases[0].energy);
      EXPECT_LE(again.cases[0].accuracy.forward_error, 1.2e-16);
    }
}

TEST(StaticAnalysis, NumbersFarAwayTakeAFactorOfTheirOwn) {
  Model model = pressed_packing(5e9, 0.2);
  StaticAnalysis analysis(model, direct());
  analysis.solve();
  model.blocks[0].parameters[1] = -0.5;
  const StaticSolution again = analysis.solve();
  EXPECT_EQ(again.report.factorisations, 1);
  EXPECT_EQ(again.cases[0].displacement, solve_statics(model, {}).cases[0].displacement);
}

// Reactions are the modulus times what depends on Poisson's ratio alone, at both ends.
TEST(StaticAnalysis, DerivativesOnAKeptFactorAreExactAtBothEnds) {
  Model model = pressed_packing(5e9, 0.2);
  StaticAnalysis analysis(model, direct());
  analysis.solve();
  model.blocks[0].parameters = {6e9, 0.2 + 1e-7};
  const StaticSolution solution = analysis.solve();
  ASSERT_EQ(solution.report.factorisations, 0);
  const auto gradients =
      analysis.gradients({{reaction_of_layer(model, true)}, {reaction_of_layer(model, false)}});
  double force = 0;
  for (const auto& [p, weight] : reaction_of_layer(model, true).reaction)
    force += weight.dot(solution.cases[0].reaction[std::size_t(p)]);
  const ParameterDerivative young = bond_derivatives(model, 0, 0, 1);
  EXPECT_NEAR(derivative(gradients[0], young), force / 6e9, 1e-13 * std::abs(force / 6e9));
  EXPECT_NEAR(derivative(gradients[1], young), -force / 6e9, 1e-13 * std::abs(force / 6e9));
}

// On a kept factor adjoint motions begin where the last ones ended, whatever those were of.
TEST(StaticAnalysis, DerivativesAfterOthersAreThoseOfAnAnalysisOfItsOwn) {
  Model model = pressed_packing(5e9, 0.2);
  Functional sideways, upwards;
  sideways.displacement.emplace_back(170, vector6(1, 0, 0, 0, 0, 0));
  upwards.displacement.emplace_back(180, vector6(0, 0, 1e9, 0, 3, 0));
  StaticAnalysis analysis(model, direct());
  analysis.solve();
  analysis.gradients({{upwards}});
  for (const std::vector<double>& parameters :
       {std::vector{6e9, 0.2 + 1e-7}, std::vector{6.1e9, 0.2 + 2e-7}}) {
    model.blocks[0].parameters = parameters;
    ASSERT_EQ(analysis.solve().report.factorisations, 0);
    const BondGradients again = analysis.gradients({{sideways}})[0];
    StaticAnalysis own(model, direct());
    own.solve();
    const BondGradients fresh = own.gradients({{sideways}})[0];
    double SectionStiffness::*const numbers_of_c[] = {&SectionStiffness::kn, &SectionStiffness::ks,
                                                      &SectionStiffness::kt, &SectionStiffness::kb};
    for (const auto number : numbers_of_c) {
      double largest = 0, difference = 0;
      for (std::size_t k = 0; k < fresh.size(); ++k) {
        const double expected = fresh[k].stiffness.*number;
        largest = std::max(largest, std::abs(expected));
        difference = std::max(difference, std::abs(again[k].stiffness.*number - expected));
      }
      EXPECT_GT(largest, 0);
      EXPECT_LE(difference, 1.2e-16 * largest);
    }
  }
}

TEST(StaticAnalysis, BeginsAnewWhereTheModelIsAnotherOne) {
  Model model = scattered_packing(6);
  StaticAnalysis analysis(model, {});
  analysis.solve();
  model.supports[1].fixed = {true, true, true, true, true, true};
  model.bonds.pop_back();
  for (auto& [parameter, own] : model.blocks[0].overrides) own.pop_back();
  const StaticSolution again = analysis.solve();
  EXPECT_EQ(again.cases[0].displacement, solve_statics(model, {}).cases[0].displacement);
}

TEST(StaticAnalysis, MayBeAskedAgainAfterAFailure) {
  Model model = scattered_packing(7);
  StaticAnalysis analysis(model, {});
  const StaticSolution before = analysis.solve();
  const double kn = std::exchange(model.blocks[0].overrides.at(0)[2], -1);
  EXPECT_ANY_THROW(analysis.solve());
  EXPECT_THROW(analysis.gradients({}), std::logic_error);
  model.blocks[0].overrides.at(0)[2] = kn;
  EXPECT_EQ(analysis.solve().cases[0].displacement, before.cases[0].displacement);
}

}  // namespace
}  // namespace bondstatic::test
