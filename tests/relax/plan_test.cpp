// What is said of a run before its first step.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/error.hpp"
#include "bondstatic/modes.hpp"
#include "relax/relax_models.hpp"

namespace bondstatic::test {
namespace {

DynamicPlan plan_of(const Model& model, RelaxOptions options) {
  options.max_steps = 1;
  return relaxed(model, options).plan;
}

/// The oscillator x'' = -x (1 + gamma where it moves away from the middle, 1 - gamma where it comes back),
/// from rest, by many small steps.
double brute_force_decay(double gamma) {
  const double dt = 1e-5;
  double x = 1, v = 0, t = 0;
  int turns = 0;
  while (turns < 4) {
    const double f = -x, before = v;
    v += dt * (f - gamma * std::copysign(std::abs(f), v == 0 ? f : v));
    x += dt * v;
    t += dt;
    turns += before * v < 0;
  }
  return -std::log(std::abs(x)) / t;
}

TEST(ParticleDampingDecay, IsThatOfAnOscillatorStepByStep) {
  // At the turning points the step's sign is late: an error of first order in dt / (1 - gamma).
  for (const double gamma : {0.01, 0.1, 0.3, 0.5, 0.7, 0.85, 0.95})
    EXPECT_NEAR(brute_force_decay(gamma) / particle_damping_decay(gamma), 1, 2e-5 / (1 - gamma)) << gamma;
  EXPECT_EQ(particle_damping_decay(0), 0);
}

TEST(Plan, BestParticleDampingIsTheLargestDecayInAStep) {
  const auto in_a_step = [](double gamma) { return particle_damping_decay(gamma) / std::sqrt(1 + gamma); };
  double best = 0;
  for (int i = 0; i < 10000; ++i)
    if (in_a_step(i * 1e-4) > in_a_step(best)) best = i * 1e-4;
  const DynamicPlan plan = plan_of(loaded_cantilever(), small_kinematics());
  EXPECT_NEAR(plan.best_particle_damping, best, 5.1e-4);  // told with three digits
  EXPECT_NEAR(in_a_step(plan.best_particle_damping) / in_a_step(best), 1, 1e-6);
  EXPECT_NEAR(plan.best_decay / (plan.lowest[0] * particle_damping_decay(best)), 1, 1e-3);
}

/// By the modes themselves, for a cantilever.
struct Spectrum {
  double highest, critical;
  std::vector<double> lowest;
};
Spectrum spectrum_of(const Model& model, const BondDamping& damping = {}) {
  const auto properties = bond_properties(model);
  BondNetwork network = bond_network(model, properties);
  std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
  free[0] = 0;
  const FreeDofs dofs = number_free_dofs(free);
  const BodyMasses masses = body_masses(model);
  const auto solver = make_solver("auto", 1);
  solver->analyse(network, dofs);
  solver->factorise(network, dofs);
  std::vector<double> lowest;
  for (const Mode& mode : lowest_modes(network, dofs, masses, *solver, 5)) lowest.push_back(mode.frequency);
  BondNetwork viscous = network;
  const auto coefficients = dashpots(model, properties, free, damping);
  for (std::size_t k = 0; k < coefficients.size(); ++k) viscous.links[k].stiffness = coefficients[k];
  return {highest_frequency(network, dofs, masses, 1),
          critical_time_step(network, damping.any() ? &viscous : nullptr, dofs, masses, 1), lowest};
}

TEST(Plan, TimeStepIsSafetyTimesTheCriticalOneInThreeDigits) {
  const Model model = loaded_cantilever();
  const Spectrum exact = spectrum_of(model);
  for (const double gamma : {0.0, 0.3, 0.7})
    for (const double safety : {0.1, 0.63, 0.8, 0.99}) {
      RelaxOptions options = small_kinematics();
      options.particle_damping = gamma;
      options.safety = safety;
      const DynamicPlan plan = plan_of(model, options);
      EXPECT_NEAR(plan.critical_time_step / (exact.critical / std::sqrt(1 + gamma)), 1, 1e-12);
      EXPECT_LE(plan.time_step, safety * plan.critical_time_step);
      EXPECT_GE(plan.time_step, 0.99 * safety * plan.critical_time_step);
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.2e", plan.time_step);
      EXPECT_NEAR(plan.time_step / std::strtod(digits, nullptr), 1, 1e-15);
      EXPECT_NEAR(plan.highest / exact.highest, 1, 1e-12);
    }
}

TEST(Plan, LowestFrequenciesAndTimesAreThoseOfTheEigenproblem) {
  const Model model = loaded_cantilever();
  const Spectrum exact = spectrum_of(model);
  RelaxOptions options = small_kinematics();
  const DynamicPlan plan = plan_of(model, options);
  ASSERT_EQ(plan.lowest.size(), exact.lowest.size());
  for (std::size_t m = 0; m < plan.lowest.size(); ++m)
    EXPECT_NEAR(plan.lowest[m] / exact.lowest[m], 1, 1e-10);
  const double period = 2 * std::numbers::pi / exact.lowest[0];
  EXPECT_LE(plan.ramp_time, period);
  EXPECT_GE(plan.ramp_time, 0.99 * period);
  EXPECT_EQ(plan.hold_time, plan.ramp_time);
  EXPECT_NEAR(plan.decay, plan.lowest[0] * particle_damping_decay(0.7), 1e-12 * plan.decay);

  options.ramp_time = 0.3;
  options.hold_time = 0.4;
  options.time_step = 1e-7;
  const DynamicPlan given = plan_of(model, options);
  EXPECT_EQ(given.ramp_time, 0.3);
  EXPECT_EQ(given.hold_time, 0.4);
  EXPECT_EQ(given.time_step, 1e-7);
}

TEST(Plan, DashpotsShortenTheStepAndAddToTheDecay) {
  const Model model = loaded_cantilever();
  RelaxOptions options = small_kinematics();
  options.particle_damping = 0;
  options.bond_damping.paper = 0.3;
  const DynamicPlan plan = plan_of(model, options);
  const Spectrum exact = spectrum_of(model, options.bond_damping);
  EXPECT_NEAR(plan.critical_time_step / exact.critical, 1, 1e-9);
  EXPECT_LT(plan.critical_time_step, 0.9 * 2 / plan.highest);
  EXPECT_GT(plan.decay, 0);
  options.particle_damping = 0.4;
  const DynamicPlan both = plan_of(model, options);
  EXPECT_LT(both.critical_time_step, plan.critical_time_step / std::sqrt(1.4) * (1 + 1e-9));
  EXPECT_NEAR(both.decay / (plan.decay + plan.lowest[0] * particle_damping_decay(0.4)), 1, 1e-12);
}

// The decay of a particle in one direction by its dashpot alone: c / 2m.
TEST(Plan, ViscousDecayOfOneMassFollowsTheClosedForm) {
  Model model = loaded_cantilever(1);
  model.supports.push_back({1, {false, true, true, true, true, true}, Vector6::Zero(), every_case});
  model.particles[1].position = model.bonds[0].branch = Vector3(0.5, 0, 0);
  RelaxOptions options = small_kinematics();
  options.particle_damping = 0;
  options.bond_damping.normal = 0.125;
  const DynamicPlan plan = plan_of(model, options);
  ASSERT_EQ(plan.lowest.size(), 1u);
  EXPECT_NEAR(plan.decay / (0.125 * plan.lowest[0]), 1, 1e-12);
  EXPECT_NEAR(plan.critical_time_step * plan.highest / (2 * (std::sqrt(1 + 0.125 * 0.125) - 0.125)), 1, 1e-9);
}

struct Case {
  const char* name;
  Model model;
  double gamma, eta;
  Ramp ramp;
};

// From the slowest mode alone. Where others of like frequency join in, as in a packing, particle damping
// stops them one at another's expense and rest comes sooner, by up to 2.4 here.
TEST(Plan, PredictsTheStepsWithinAFactor) {
  const BondBlock beam = block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}});
  const Case cases[] = {{"cantilever, 0.7", loaded_cantilever(), 0.7, 0, Ramp::linear},
                        {"cantilever, 0.1", loaded_cantilever(), 0.1, 0, Ramp::linear},
                        {"long cantilever, 0.4", loaded_cantilever(15), 0.4, 0, Ramp::smooth},
                        {"cantilever, dashpots", loaded_cantilever(), 0, 0.5, Ramp::linear},
                        {"packing, 0.7", loaded_packing(3, beam), 0.7, 0, Ramp::linear},
                        {"packing, 0.3", loaded_packing(4, beam), 0.3, 0, Ramp::smooth},
                        {"packing, both", loaded_packing(3, beam), 0.2, 0.05, Ramp::linear}};
  for (const Case& c : cases) {
    RelaxOptions options = small_kinematics();
    options.particle_damping = c.gamma;
    options.bond_damping.paper = c.eta;
    options.ramp = c.ramp;
    const RelaxedCase result = relaxed(c.model, options);
    EXPECT_EQ(result.end, RunEnd::at_rest) << c.name;
    const double ratio = double(result.steps) / result.plan.predicted_steps;
    RecordProperty(std::string(c.name), std::to_string(ratio));
    EXPECT_GT(ratio, 0.4) << c.name;
    EXPECT_LT(ratio, 1.1) << c.name;
  }
}

TEST(Plan, WithoutDampingRestIsNeverPredicted) {
  RelaxOptions options = small_kinematics();
  options.particle_damping = 0;
  const DynamicPlan plan = plan_of(loaded_cantilever(), options);
  EXPECT_EQ(plan.decay, 0);
  EXPECT_TRUE(std::isinf(plan.predicted_steps));
  EXPECT_GT(plan.best_decay, 0);
  EXPECT_TRUE(std::isfinite(plan.best_predicted_steps));
}

TEST(Plan, WithoutMemoryForTheFactorNeedsTheTimesGiven) {
  StaticOptions solve = one_thread();
  solve.memory_limit = 10000;  // the run itself fits
  RelaxOptions options = small_kinematics();
  options.max_steps = 1;
  const auto refusal = [&] {
    try {
      relax(loaded_cantilever(), options, solve);
    } catch (const MemoryError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_NE(refusal().find("cure: give ramp_time and hold_time"), std::string::npos) << refusal();
  options.ramp_time = 0.1;
  EXPECT_NE(refusal().find("cure: give ramp_time and hold_time"), std::string::npos) << refusal();
  options.hold_time = 0.1;
  const DynamicPlan plan = relax(loaded_cantilever(), options, solve).cases[0].plan;
  EXPECT_TRUE(plan.lowest.empty());
  EXPECT_GT(plan.critical_time_step, 0);
}

}  // namespace
}  // namespace bondstatic::test
