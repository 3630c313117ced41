// Loads that ramp and hold, supports that move.
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/error.hpp"
#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

DynamicOptions ramped(Ramp ramp, double ramp_time, double dt, double load_factor = 1) {
  DynamicOptions options;
  options.kinematics = Kinematics::small;
  options.particle_damping = 0;
  options.time_step = dt;
  options.ramp = ramp;
  options.ramp_time = ramp_time;
  options.load_factor = load_factor;
  return options;
}

Model beam_of(Index bonds) {
  Model model = chain(block("timoshenko", {{"young", 1e8}, {"poisson", 0.3}, {"radius", 0.1}}),
                      Vector3::Zero(), Vector3(0, 0, -0.4 * double(bonds)), bonds, 0.2);
  give_density(model, 2000);
  return model;
}

TEST(LoadFactor, FollowsItsRampAndHolds) {
  const Model model = beam_of(1);
  const double time = 0.0125, dt = 1e-4, full = 0.7;  // 125 steps
  ExplicitRun linear = explicit_run(model, ramped(Ramp::linear, time, dt, full));
  ExplicitRun smooth = explicit_run(model, ramped(Ramp::smooth, time, dt, full));
  for (Index n = 0; n <= 200; ++n) {
    const double s = std::min(1.0, double(n) * dt / time);
    EXPECT_NEAR(linear.load_factor(), full * s, 1e-15) << n;
    EXPECT_NEAR(smooth.load_factor(), full * s * s * (3 - 2 * s), 1e-15) << n;
    linear.advance(1);
    smooth.advance(1);
  }
  EXPECT_EQ(linear.step(), 201);
  EXPECT_DOUBLE_EQ(linear.time(), 201 * dt);
  EXPECT_EQ(explicit_run(model, ramped(Ramp::smooth, 0, dt, full)).load_factor(), full);
}

class MovedSupport : public ::testing::TestWithParam<std::tuple<Kinematics, Ramp>> {};

TEST_P(MovedSupport, GoesWithTheRampToExactlyItsValue) {
  const auto& [kinematics, ramp] = GetParam();
  Model model = beam_of(3);
  const Vector6 value = vector6(0.01, -0.02, 0.03, 0.01, 0.02, -0.03);
  hold(model, 3, "xyzv", value);
  const double dt = 1e-4;
  DynamicOptions options = ramped(ramp, 1000.5 * dt, dt, 0.8);
  options.kinematics = kinematics;
  options.particle_damping = 0.1;
  ExplicitRun run = explicit_run(model, options);
  for (int look = 0; look < 15; ++look) {
    run.advance(100);
    const Vector6 at = run.state().displacement[3];
    for (const int i : {0, 1, 2}) EXPECT_NEAR(at[i], run.load_factor() * value[i], 1e-15) << look;
    if (kinematics == Kinematics::small) {
      EXPECT_NEAR(at[4], run.load_factor() * value[4], 1e-15) << look;
    }
  }
  EXPECT_EQ(run.load_factor(), 0.8);
  EXPECT_TRUE(run.state().displacement[0].isZero(0));
  for (const int i : {0, 1, 2, 4}) EXPECT_EQ(run.velocity(3)[i], 0) << i;
}

INSTANTIATE_TEST_SUITE_P(Ramp, MovedSupport,
                         ::testing::Combine(::testing::Values(Kinematics::small, Kinematics::finite),
                                            ::testing::Values(Ramp::linear, Ramp::smooth)));

TEST(MovedSupport, TurnsThroughAFiniteAngleToExactlyItsValue) {
  const double angle = 2.5;
  for (const Ramp ramp : {Ramp::linear, Ramp::smooth}) {
    Model model = beam_of(2);
    fix_all(model, 2, vector6(0.01, 0, 0, 0.6 * angle, 0, 0.8 * angle));
    DynamicOptions options = ramped(ramp, 50.3e-4, 1e-4, 0.9);  // few steps, and it ends within one
    options.kinematics = Kinematics::finite;
    ExplicitRun run = explicit_run(model, options);
    for (int look = 0; look < 6; ++look) {
      run.advance(10);
      const Vector3 expected = run.load_factor() * angle * Vector3(0.6, 0, 0.8);
      EXPECT_LT((run.state().displacement[2].tail<3>() - expected).norm(), 1e-14);
    }
    EXPECT_EQ(run.load_factor(), 0.9);
  }
}

// Under weights alone a free chain falls as one body; leapfrog does parabolas exactly.
TEST(Weight, LetsAFreeChainFallAsABody) {
  Model model = beam_of(4);
  model.supports.clear();
  const double g = 9.81, dt = 1e-3;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    model.particles[p].density = 1000 * double(p + 1);
    load(model, Index(p), vector6(0, 0, -g * mass(model.particles[p])));
  }
  ExplicitRun run = explicit_run(model, ramped(Ramp::linear, 0, dt));
  run.advance(1000);
  double weight = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    EXPECT_NEAR(run.state().displacement[p][2] / (-g / 2), 1, 1e-12) << p;
    EXPECT_NEAR(run.velocity(Index(p))[2] / -g, 1, 1e-12) << p;
    weight += g * mass(model.particles[p]);
  }
  EXPECT_NEAR(run.energies().work / (weight * g / 2), 1, 1e-12);
  EXPECT_NEAR(run.energies().kinetic / (weight * g / 2), 1, 1e-12);
  EXPECT_LT(run.energies().strain, 1e-20 * weight);
}

TEST(Weight, HangsOnTheSupport) {
  Model model = beam_of(4);
  double weight = 0;
  for (Index p = 1; p <= 4; ++p) {
    load(model, p, vector6(0, 0, -9.81 * mass(model.particles[std::size_t(p)])));
    weight += 9.81 * mass(model.particles[std::size_t(p)]);
  }
  DynamicOptions options = ramped(Ramp::smooth, 0.1, 2e-4);
  options.particle_damping = 0.7;
  ExplicitRun run = explicit_run(model, options);
  run.advance(20000);
  EXPECT_NEAR(run.state().reaction[0][2] / weight, 1, 1e-12);
  EXPECT_NEAR(run.bond_force(0)[2] / -weight, 1, 1e-12);
  EXPECT_LT(run.unrest().unbalanced, 1e-12);
}

TEST(ExplicitRun, NamesAParticleWithoutDensity) {
  Model model = beam_of(3);
  model.particles[2].density = not_given;
  model.particles[0].density = not_given;  // held, so it needs none
  try {
    explicit_run(model, ramped(Ramp::linear, 0, 1e-4));
    FAIL() << "ran without mass";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_NE(std::string(error.what()).find("particle 3 has no density"), std::string::npos) << error.what();
  }
  const ExplicitRun run(model, bond_properties(model), 0, {false, false, true, true},
                        ramped(Ramp::linear, 0, 1e-4));
  EXPECT_TRUE(std::isnan(run.state().displacement[2][0]));
  EXPECT_FALSE(std::isnan(run.state().displacement[1][0]));
}

}  // namespace
}  // namespace bondstatic::test
