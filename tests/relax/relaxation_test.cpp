// The state of rest is the static answer, and rest is not taken for what it is not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/error.hpp"
#include "bondstatic/mechanism.hpp"
#include "relax/relax_models.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

/// Largest difference over the largest entry; rotations as they are (lengths are of order one).
double difference(const std::vector<Vector6>& a, const std::vector<Vector6>& b) {
  double most = 0, largest = 0;
  for (std::size_t p = 0; p < a.size(); ++p) {
    most = std::max(most, (a[p] - b[p]).cwiseAbs().maxCoeff());
    largest = std::max(largest, b[p].cwiseAbs().maxCoeff());
  }
  return most / largest;
}

double largest_difference(const State& dynamic, const State& still) {
  std::vector<Vector6> forces, expected;
  for (std::size_t k = 0; k < dynamic.bonds.size(); ++k) {
    forces.push_back(dynamic.bonds[k].force);
    expected.push_back(still.bonds[k].force);
  }
  return std::max({difference(dynamic.displacement, still.displacement),
                   difference(dynamic.reaction, still.reaction), difference(forces, expected),
                   std::abs(dynamic.energy / still.energy - 1)});
}

RelaxOptions to_rest_of(double velocity) {
  RelaxOptions options = small_kinematics();
  options.velocity_limit = velocity;
  return options;
}

struct Law {
  const char* name;
  Values values;
  ContactPoint contact_point;
};

class RestOfAPacking : public ::testing::TestWithParam<Law> {};

TEST_P(RestOfAPacking, IsTheStaticAnswerWhereKinematicsAreSmall) {
  const Law& law = GetParam();
  const Model model = loaded_packing(4, block(law.name, law.values, law.contact_point));
  const RelaxedCase found = relaxed(model, to_rest_of(1e-11));
  EXPECT_EQ(found.end, RunEnd::at_rest);
  EXPECT_LT(found.unrest.unbalanced, 1e-8);
  EXPECT_LT(found.unrest.fastest, 1e-11);
  EXPECT_LT(found.energies.balance(), 1e-14);
  const double worst = largest_difference(found.state, solve_statics(model, one_thread()).cases[0]);
  RecordProperty("difference", std::to_string(1e9 * worst) + "e-9");
  EXPECT_LT(worst, 1e-9);  // of the stopping rule: 1e-8 of the loads at most are not in balance
}

const Law laws[] = {
    {"timoshenko", {{"young", 5e9}, {"poisson", 0.2}}, {}},
    {"parallel", {{"young", 5e9}, {"kappa", 3}}, {}},
    {"parallel", {{"young", 5e9}, {"kappa", 3}}, {ContactPoint::Kind::fraction, 0.3}},
    {"two-segment", {{"young", 5e9}, {"poisson", 0.2}}, {}},
    {"edem-v2", {{"normal_stiffness", 4e9}, {"shear_stiffness", 2e9}, {"torque_feedback", 0}}, {}},
    {"contact", {{"kn", 4e9}, {"ks", 2e9}}, {}}};

INSTANTIATE_TEST_SUITE_P(Relaxation, RestOfAPacking, ::testing::ValuesIn(laws));

TEST(Relaxation, EveryLoadCaseEndsAtItsOwnAnswer) {
  Model model = loaded_packing(3, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  model.load_cases = {"one", "two", "three"};
  load(model, 20, vector6(-3e4, 0, 0), 1);
  model.supports.push_back({23, {true, true, true, true, true, true}, vector6(0, 0, 3e-5), 2});
  const Relaxation found = relax(model, to_rest_of(1e-11), one_thread());
  const StaticSolution still = solve_statics(model, one_thread());
  ASSERT_EQ(found.cases.size(), 3u);
  EXPECT_TRUE(found.at_rest());
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(found.cases[c].state.name, model.load_cases[c]);
    EXPECT_LT(largest_difference(found.cases[c].state, still.cases[c]), 1e-7) << c;
    EXPECT_EQ(std::abs(found.cases[c].state.displacement[23][2] - 3e-5) < 1e-18, c == 2) << c;
  }
}

TEST(Relaxation, LoadFactorScalesLoadsAndPrescribedMotions) {
  const Model model = loaded_packing(3, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  RelaxOptions options = to_rest_of(1e-11);
  options.load_factor = 0.25;
  State found = relaxed(model, options).state;
  const State still = solve_statics(model, one_thread()).cases[0];
  for (Vector6& u : found.displacement) u *= 4;
  EXPECT_LT(difference(found.displacement, still.displacement), 1e-7);
  EXPECT_NEAR(found.energy * 16 / still.energy, 1, 1e-7);
}

// Finite kinematics differ from the linear answer at second order: by half as much at half the load.
TEST(Relaxation, FiniteKinematicsEndInProportionToTheLoadSquared) {
  const Model model = loaded_cantilever();
  const State still = solve_statics(model, one_thread()).cases[0];
  const auto away = [&](double factor) {
    RelaxOptions options;
    options.velocity_limit = 1e-11;
    options.load_factor = factor;
    State found = relaxed(model, options).state;
    for (Vector6& u : found.displacement) u /= factor;
    return difference(found.displacement, still.displacement);
  };
  const double full = away(1);
  EXPECT_GT(full, 1e-5);
  EXPECT_NEAR(full / away(0.5), 2, 0.02);
}

// Without damping everything stops for a moment, at every turning point. A limit far above the rounding of
// such a moment and below the speed between is not met for a whole period.
TEST(Relaxation, TurningPointIsNotRest) {
  Model model = loaded_cantilever(1);
  model.loads.clear();
  model.particles[1].position = model.bonds[0].branch = Vector3(0.5, 0, 0);
  model.supports.push_back({1, {false, true, true, true, true, true}, Vector6::Zero(), every_case});
  load(model, 1, vector6(10, 0, 0));
  for (const double gamma : {0.0, 0.001}) {
    RelaxOptions options = small_kinematics();
    options.particle_damping = gamma;
    options.ramp_time = 0;
    options.safety = 0.02;     // some 150 steps a period
    options.force_limit = 10;  // only speed decides
    options.max_steps = 1000;
    const std::vector<double> fastest = column(relaxed(model, options), "fastest");
    options.velocity_limit = 0.3 * *std::max_element(fastest.begin(), fastest.end());
    options.max_steps = 20000;
    const RelaxedCase found = relaxed(model, options);
    EXPECT_EQ(found.end, RunEnd::step_limit);
    EXPECT_EQ(found.steps, 20000);
    int calm = 0;
    for (const double speed : column(found, "fastest")) calm += speed < options.velocity_limit;
    EXPECT_GT(calm, 200) << "no look ever fell on a turning point";
  }
}

TEST(Relaxation, IsNotAtRestBeforeItsLoadsAreFull) {
  RelaxOptions options = small_kinematics();
  options.ramp_time = 2;
  options.hold_time = 0.5;
  options.velocity_limit = options.force_limit = 1e9;  // calm from the first look
  const RelaxedCase found = relaxed(loaded_cantilever(), options);
  EXPECT_EQ(found.end, RunEnd::at_rest);
  EXPECT_GE(found.time, 2.5);
  EXPECT_LT(found.time, 2.5 + 3 * options.hold_time / 16);  // looks are so far apart
}

TEST(Relaxation, BothLimitsHoldForTheHoldTime) {
  RelaxOptions options = small_kinematics();
  options.hold_time = 0.5;
  const RelaxedCase found = relaxed(loaded_cantilever(), options);
  ASSERT_EQ(found.end, RunEnd::at_rest);
  const auto &time = column(found, "time"), &fastest = column(found, "fastest"),
             &unbalanced = column(found, "unbalanced");
  EXPECT_EQ(time.back(), found.time);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < found.time - 0.5 + 1e-12) continue;
    EXPECT_LT(fastest[i], options.velocity_limit);
    EXPECT_LT(unbalanced[i], options.force_limit);
  }
}

Model with_rattlers() {
  Model model = loaded_packing(3, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  for (const double x : {10.0, 20.0, 21.0}) add_particle(model, Vector3(x, 0, 0), 0.5);  // without density
  add_bond(model, 28, 29);
  return model;
}

TEST(Relaxation, LeavesOutUnsupportedBodiesWhereAsked) {
  EXPECT_THROW(relax(with_rattlers(), small_kinematics(), one_thread()), MechanismError);
  StaticOptions drop = one_thread();
  drop.unsupported = Unsupported::drop;
  const Relaxation found = relax(with_rattlers(), small_kinematics(), drop);
  EXPECT_EQ(found.dropped, (std::vector<std::vector<Index>>{{28}, {29, 30}}));
  EXPECT_TRUE(found.at_rest());
  EXPECT_TRUE(std::isnan(found.cases[0].state.displacement[28][0]));
  EXPECT_TRUE(std::isnan(found.cases[0].state.bonds.back().normal_force));
  Model alone = with_rattlers();
  alone.particles.resize(27);
  alone.bonds.pop_back();
  const RelaxedCase without = relaxed(alone, small_kinematics());
  EXPECT_EQ(without.steps, found.cases[0].steps);
  for (std::size_t p = 0; p < 27; ++p)
    EXPECT_EQ(without.state.displacement[p], found.cases[0].state.displacement[p]);
}

TEST(Relaxation, NamesAMechanism) {
  Model model = loaded_cantilever();
  model.blocks[0] = block("contact", {{"kn", 1e6}, {"ks", 1e6}});
  try {
    relaxed(model, small_kinematics());
    FAIL() << "ran a chain of hinges";
  } catch (const MechanismError& error) {
    EXPECT_THAT(error.what(), HasSubstr("rotate"));
  }
}

TEST(Relaxation, NamesAParticleWithoutDensity) {
  Model model = loaded_cantilever();
  model.particles[3].density = not_given;
  try {
    relaxed(model, small_kinematics());
    FAIL() << "ran without mass";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("particle 4 has no density"));
    EXPECT_THAT(error.what(), HasSubstr("cure"));
  }
}

TEST(Relaxation, WholeModelHeldIsAtRestAtOnce) {
  Model model = loaded_cantilever(1);
  fix_all(model, 1, vector6(1e-3, 0, 0));
  const RelaxedCase found = relaxed(model, small_kinematics());
  EXPECT_EQ(found.end, RunEnd::at_rest);
  EXPECT_LT(found.steps, 20);
  EXPECT_LT(largest_difference(found.state, solve_statics(model, one_thread()).cases[0]), 1e-14);
}

// A load along the highest mode, so that an unstable step shows.
RelaxOptions at_share_of_critical(const Model& model, double share, Index steps) {
  RelaxOptions options = small_kinematics();
  options.particle_damping = 0;
  options.max_steps = 2;
  options.time_step = share * relaxed(model, options).plan.critical_time_step;
  options.max_steps = steps;
  return options;
}

TEST(Relaxation, BlowsUpAboveTheCriticalStepAndSaysSo) {
  const Model model = loaded_cantilever();
  const RelaxOptions options = at_share_of_critical(model, 1.01, 200000);
  try {
    relaxed(model, options);
    FAIL() << "did not blow up";
  } catch (const AccuracyError& error) {
    EXPECT_EQ(error.code(), ExitCode::not_accurate);
    EXPECT_THAT(error.what(), HasSubstr("blew up"));
    EXPECT_THAT(error.what(), HasSubstr("1.01 times the critical one"));
    EXPECT_THAT(error.what(), HasSubstr("cure: leave time_step out"));
  }
}

TEST(Relaxation, DoesNotBlowUpBelowTheCriticalStep) {
  const Model model = loaded_cantilever();
  const RelaxedCase found = relaxed(model, at_share_of_critical(model, 0.99, 200000));
  EXPECT_EQ(found.end, RunEnd::step_limit);
  EXPECT_EQ(found.steps, 200000);
  EXPECT_LT(found.energies.balance(), 1e-12);
}

// One step into a ramp a particle has speed and has gone no way: that is no blow-up.
TEST(Relaxation, LooksAtEveryStepWhereTheHoldTimeIsShort) {
  Model model = loaded_cantilever(1);
  for (const Ramp ramp : {Ramp::linear, Ramp::smooth}) {
    RelaxOptions options = to_rest_of(1e-11);
    options.ramp = ramp;
    options.record_interval = 1e-9;
    const RelaxedCase found = relaxed(model, options);
    EXPECT_EQ(found.end, RunEnd::at_rest);
    EXPECT_EQ(column(found, "step")[1], 1);
  }
}

}  // namespace
}  // namespace bondstatic::test
