// Momentum and energy of bodies that nothing holds.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Momentum {
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
  double size = 0;  ///< sum of magnitudes, to compare rounding with
};

/// Angular about the origin of space. With velocities of the whole step, the mean of those half a step before
/// and after, x(n) x v(n) is the mean of both halves' angular momentum, which the scheme keeps.
Momentum momentum(const Model& model, const ExplicitRun& run, bool places_follow) {
  const State state = run.state();
  Momentum sum;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const Particle& particle = model.particles[p];
    const Vector6 velocity = run.velocity(Index(p));
    Vector3 place = particle.position;
    if (places_follow) place += state.displacement[p].head<3>();
    const Vector3 linear = mass(particle) * velocity.head<3>();
    const Vector3 spin = moment_of_inertia(particle) * velocity.tail<3>();
    sum.linear += linear;
    sum.angular += place.cross(linear) + spin;
    sum.size += place.norm() * linear.norm() + spin.norm();
  }
  return sum;
}

DynamicOptions free_motion(Kinematics kinematics, double dt) {
  DynamicOptions options;
  options.kinematics = kinematics;
  options.particle_damping = 0;
  options.time_step = dt;
  return options;
}

class FreePair : public ::testing::TestWithParam<Kinematics> {};

TEST_P(FreePair, KeepsItsMomentaThroughAHundredThousandSteps) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> some(-1, 1);
  for (const BondDamping& dashpots : {BondDamping{}, BondDamping{.paper = 0.02}}) {
    Model model = pair(block("generic", {{"kn", 5e4}, {"ks", 2e4}, {"kt", 700}, {"kb", 1100}},
                             {ContactPoint::Kind::fraction, 0.23}),
                       skew_axes(), 1.25, 0.3, 0.5);
    model.particles[0].density = 1500;
    model.particles[1].density = 2700;
    DynamicOptions options = free_motion(GetParam(), 1e-3);
    options.bond_damping = dashpots;
    ExplicitRun run = explicit_run(model, options);
    for (Index p = 0; p < 2; ++p)
      run.set_velocity(
          p, vector6(some(random), some(random), some(random), some(random), some(random), some(random)));
    const bool follow = GetParam() == Kinematics::finite;
    const Momentum before = momentum(model, run, follow);
    double linear = 0, angular = 0, strained = 0;
    for (int look = 0; look < 100; ++look) {
      run.advance(1000);
      const Momentum now = momentum(model, run, follow);
      linear = std::max(linear, (now.linear - before.linear).norm() / before.linear.norm());
      angular = std::max(angular, (now.angular - before.angular).norm() / now.size);
      strained = std::max(strained, run.energies().strain);
    }
    RecordProperty("linear", std::to_string(1e15 * linear) + "e-15");
    RecordProperty("angular", std::to_string(1e15 * angular) + "e-15");
    EXPECT_LT(linear, 1e-12);
    EXPECT_LT(angular, 1e-12);
    EXPECT_GT(strained, 0.01 * run.energies().initial);  // momentum did change hands
  }
}

INSTANTIATE_TEST_SUITE_P(Conservation, FreePair, ::testing::Values(Kinematics::small, Kinematics::finite));

constexpr Index links = 7;

/// Eight particles along e_x of `axes`, nothing held.
Model free_chain(const Matrix3& axes) {
  Model model = chain(block("timoshenko", {{"young", 1e8}, {"poisson", 0.3}, {"radius", 0.1}}),
                      Vector3::Zero(), 2.8 * axes.col(0), links, 0.2);
  model.supports.clear();
  give_density(model, 2000);
  return model;
}

/// Starts in rigid rotation about the middle.
ExplicitRun spinning(const Model& model, const Vector3& spin, double dt) {
  ExplicitRun run = explicit_run(model, free_motion(Kinematics::finite, dt));
  const Vector3 middle = 0.5 * (model.particles.front().position + model.particles.back().position);
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    Vector6 velocity;
    velocity << spin.cross(model.particles[p].position - middle), spin;
    run.set_velocity(Index(p), velocity);
  }
  return run;
}

struct Drift {
  double energy = 0;       ///< what the balance leaves over the initial energy, largest
  double orientation = 0;  ///< of the end particle against the chain's chord
  double turns = 0;
};

Drift after_turns(double turns, double rate, double dt) {
  const Matrix3 axes = skew_axes();
  const Model model = free_chain(axes);
  ExplicitRun run = spinning(model, rate * axes.col(2), dt);
  Drift drift;
  double last = 0;
  while (run.time() < turns * 2 * pi / rate) {
    run.advance(20);
    const State state = run.state();
    const Energies e = run.energies();
    const double left = e.kinetic - e.held_back + e.strain - e.initial;
    drift.energy = std::max(drift.energy, std::abs(left) / e.initial);
    const Vector3 chord = model.particles[links].position + state.displacement[links].head<3>() -
                          model.particles[0].position - state.displacement[0].head<3>();
    const Vector3 carried = run.orientation(0) * axes.col(0);
    drift.orientation = std::max(drift.orientation, (carried - chord.normalized()).norm());
    const double angle = std::atan2(chord.dot(axes.col(1)), chord.dot(axes.col(0)));
    drift.turns += std::remainder(angle - last, 2 * pi) / (2 * pi);
    last = angle;
  }
  return drift;
}

TEST(SpinningChain, KeepsItsEnergyToSecondOrderInTheStep) {
  const double turns = 5, dt = 1e-4;
  const Drift coarse = after_turns(turns, 10, dt), fine = after_turns(turns, 10, dt / 2);
  RecordProperty("energy_drift", std::to_string(1e9 * coarse.energy) + "e-9");
  RecordProperty("energy_drift_at_half_the_step", std::to_string(1e9 * fine.energy) + "e-9");
  EXPECT_LT(coarse.energy, 1e-4);
  EXPECT_GE(coarse.energy / fine.energy, 4 * 0.99);
  EXPECT_NEAR(fine.turns / turns, 1, 0.02);  // it stretches, and so slows down
}

// Centrifugal force stretches the chain, and while it stretches Coriolis' bends it: the end particle may
// differ from the chord by an angle of third order in the rate of rotation, not by one that grows with the
// turns.
TEST(SpinningChain, ParticlesTurnWithIt) {
  const Drift fast = after_turns(3, 10, 1e-4), slow = after_turns(3, 1, 1e-4);
  RecordProperty("orientation", std::to_string(1e9 * slow.orientation) + "e-9");
  EXPECT_LT(slow.orientation, 3e-6);
  EXPECT_NEAR(fast.orientation / slow.orientation, 1000, 100);
  EXPECT_NEAR(slow.turns / 3, 1, 1e-3);
}

// About its own axis nothing moves but the quaternions: each step turns by 2 atan(spin dt / 2).
TEST(SpinningChain, AboutItsAxisIsFreeOfForces) {
  const Matrix3 axes = skew_axes();
  const Model model = free_chain(axes);
  const double rate = 10, dt = 1e-3;
  const Index steps = 10000;
  ExplicitRun run = spinning(model, rate * axes.col(0), dt);
  run.advance(steps);
  EXPECT_LT(run.state().energy, 1e-25 * run.energies().initial);
  const Eigen::Quaterniond expected(
      Eigen::AngleAxisd(double(steps) * 2 * std::atan(rate * dt / 2), axes.col(0)));
  for (Index p = 0; p <= links; ++p) EXPECT_LT(run.orientation(p).angularDistance(expected), 1e-11) << p;
}

}  // namespace
}  // namespace bondstatic::test
