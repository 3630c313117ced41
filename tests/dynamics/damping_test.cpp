// Particle damping (Eq. 11-12) and dashpots (Eq. 9-10) on one degree of freedom.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/relaxation.hpp"
#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

constexpr double kn = 5e4, ks = 2e4, kt = 700, kb = 1100, length = 1, arm = 0.5;
constexpr double pi = std::numbers::pi;

/// Bond along x with the contact point in the middle; nothing held.
Model pair_along_x(double density_a, double density_b) {
  Model model = pair(block("generic", {{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}}), Matrix3::Identity(),
                     length, 0.5, 0.4);
  for (Particle& particle : model.particles) particle.position -= Vector3(0.1, -0.2, 0.3);
  model.particles[0].density = density_a;
  model.particles[1].density = density_b;
  return model;
}

/// b may only move in degree of freedom `dof`; a is held.
Model one_free(int dof) {
  Model model = pair_along_x(1000, 2000);
  fix_all(model, 0);
  std::string held = "xyzuvw";
  held.erase(std::size_t(dof), 1);
  hold(model, 1, held);
  return model;
}

double inertia_in(const Particle& particle, int dof) {
  return dof < 3 ? mass(particle) : moment_of_inertia(particle);
}

Vector6 along(int dof, double value) {
  return value * Vector6::Unit(dof);
}

DynamicOptions options_with(double gamma, const BondDamping& damping, double dt) {
  DynamicOptions options;
  options.kinematics = Kinematics::small;
  options.particle_damping = gamma;
  options.bond_damping = damping;
  options.time_step = dt;
  return options;
}

struct HalfCycle {
  double zero = 0;     ///< time at which it passes through the middle
  double extreme = 0;  ///< turning point after it
};

/// By a line and by a parabola through the steps there.
std::vector<HalfCycle> half_cycles(ExplicitRun& run, int dof, double dt, std::size_t count) {
  std::vector<HalfCycle> found{{0, 0}};
  double u0 = 0, u1 = 0;
  for (Index n = 1; found.size() <= count; ++n) {
    run.advance(1);
    const double u2 = run.state().displacement[1][dof];
    if (u1 * u2 < 0) found.push_back({dt * (double(n - 1) + u1 / (u1 - u2)), 0});
    if ((u1 - u0) * (u2 - u1) < 0)
      found.back().extreme = u1 - std::pow(u2 - u0, 2) / (8 * (u2 - 2 * u1 + u0));
    u0 = u1;
    u1 = u2;
  }
  found.pop_back();
  return found;
}

class ParticleDamping : public ::testing::TestWithParam<double> {};

// Damping changes its sign at the whole step next to a turning point, up to half a step early or late: that
// moves the turning point by a part of a step, (w dt)^2 of its height, and the time by first order.
TEST_P(ParticleDamping, HalfCyclesFollowTheClosedForms) {
  const double gamma = GetParam(), step = 2e-4;
  for (const int dof : {0, 3}) {
    const Model model = one_free(dof);
    const double k = dof == 0 ? kn : kt, w = std::sqrt(k / inertia_in(model.particles[1], dof)),
                 dt = step / w;
    ExplicitRun run = explicit_run(model, options_with(gamma, {}, dt));
    run.set_velocity(1, along(dof, 0.3));
    const auto found = half_cycles(run, dof, dt, 6);
    const double ratio = std::sqrt((1 - gamma) / (1 + gamma));
    const double half_cycle = pi / (2 * w) * (1 / std::sqrt(1 - gamma) + 1 / std::sqrt(1 + gamma));
    const double height = step * step * gamma / (1 - gamma), late = 2 * dt * gamma / (1 - gamma);
    EXPECT_NEAR(found[0].extreme / (0.3 / (w * std::sqrt(1 + gamma))), 1, height + step * step);
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].extreme / found[i - 1].extreme / -ratio, 1, height + step * step);
      EXPECT_NEAR(found[i].zero - found[i - 1].zero, half_cycle, late + step * dt);
    }
    const double decay = std::log(found.front().extreme / -found.back().extreme) /
                         (w * (found.back().zero - found.front().zero));
    EXPECT_NEAR(decay / particle_damping_decay(gamma), 1, late / half_cycle);
  }
}

INSTANTIATE_TEST_SUITE_P(Damping, ParticleDamping, ::testing::Values(0.05, 0.3, 0.7, 0.9));

TEST(ParticleDamping, TakesWhatTheEnergyLoses) {
  const Model model = one_free(0);
  const double w = std::sqrt(kn / mass(model.particles[1]));
  ExplicitRun run = explicit_run(model, options_with(0.5, {}, 0.01 / w));
  run.set_velocity(1, along(0, 0.3));
  run.advance(20000);
  const Energies e = run.energies();
  EXPECT_NEAR(e.initial / (mass(model.particles[1]) * 0.09 / 2), 1, 1e-15);
  EXPECT_NEAR(e.dissipated / e.initial, 1, 1e-13);
  EXPECT_LT(e.kinetic + e.strain, 1e-20 * e.initial);
}

/// The lagged scheme on one degree of freedom, kicked: the dashpot's force is that of the velocity half a
/// step before.
struct Oscillator {
  double m, k, c, dt;
  double u = 0, v = 0, dissipated = 0;

  void step() {
    const double before = v;
    v += dt * (-k * u - c * v) / m;
    u += dt * v;
    dissipated += 0.5 * dt * c * (before + v) * v;
  }
};

void expect_follows(ExplicitRun& run, Oscillator exact, int dof, double kick) {
  exact.v = kick;
  double worst = 0, largest = 0;
  // The very first half step has no dashpot force yet, in the run as in the recursion.
  exact.u = exact.dt * exact.v;
  exact.dissipated = 0.5 * exact.dt * exact.c * exact.v * exact.v;
  run.advance(1);
  for (int n = 0; n < 3000; ++n) {
    const State state = run.state();
    worst = std::max(worst, std::abs(state.displacement[1][dof] - state.displacement[0][dof] - exact.u));
    largest = std::max(largest, std::abs(exact.u));
    run.advance(1);
    exact.step();
  }
  EXPECT_LT(worst, 1e-12 * largest);
  const double expected = exact.dissipated, found = run.energies().dissipated;
  EXPECT_NEAR(found, expected, 1e-12 * expected);
}

struct Component {
  int dof;
  double k, c;  ///< of b where a is held; c for eta = 1
};

/// Stiffness and dashpot of b's six motions. Where b only turns, its translations are held like a's: nothing
/// is left of the mass and of the force dashpots.
std::vector<Component> own_stiffness_form(double m, double i) {
  const double kr = kb + ks * arm * arm;
  return {{0, kn, 2 * std::sqrt(kn * m)}, {1, ks, 2 * std::sqrt(ks * m)}, {2, ks, 2 * std::sqrt(ks * m)},
          {3, kt, 2 * std::sqrt(kt * i)}, {4, kr, 2 * std::sqrt(kb * i)}, {5, kr, 2 * std::sqrt(kb * i)}};
}

std::vector<Component> printed_form(double m, double i) {
  const double force = 2 * std::sqrt(kn * m), moment = 2 * std::sqrt(2 * kt * i), kr = kb + ks * arm * arm;
  return {{0, kn, force}, {1, ks, force}, {2, ks, force}, {3, kt, moment}, {4, kr, moment}, {5, kr, moment}};
}

TEST(Dashpots, FollowTheLaggedRecursionInEveryComponent) {
  const double eta = 0.07;
  const BondDamping own{.normal = eta, .shear = 2 * eta, .twisting = 3 * eta, .bending = 4 * eta};
  const double share[] = {eta, 2 * eta, 2 * eta, 3 * eta, 4 * eta, 4 * eta};
  for (int dof = 0; dof < 6; ++dof) {
    SCOPED_TRACE(dof);
    const Model model = one_free(dof);
    const double m = mass(model.particles[1]), i = moment_of_inertia(model.particles[1]);
    const Component printed = printed_form(m, i)[std::size_t(dof)],
                    mine = own_stiffness_form(m, i)[std::size_t(dof)];
    const double body = inertia_in(model.particles[1], dof), dt = 0.2 * std::sqrt(body / mine.k);
    ExplicitRun first = explicit_run(model, options_with(0, {.paper = eta}, dt));
    first.set_velocity(1, along(dof, 0.3));
    expect_follows(first, {body, printed.k, eta * printed.c, dt}, dof, 0.3);
    ExplicitRun second = explicit_run(model, options_with(0, own, dt));
    second.set_velocity(1, along(dof, 0.3));
    expect_follows(second, {body, mine.k, share[dof] * mine.c, dt}, dof, 0.3);
  }
}

TEST(Dashpots, BetweenTwoFreeParticlesSeeTheReducedMass) {
  Model model = pair_along_x(1000, 2000);
  for (Index p = 0; p < 2; ++p) hold(model, p, "yzuvw");
  const double a = mass(model.particles[0]), b = mass(model.particles[1]), m = a * b / (a + b), eta = 0.3;
  const double dt = 0.2 * std::sqrt(m / kn);
  ExplicitRun run = explicit_run(model, options_with(0, {.normal = eta}, dt));
  run.set_velocity(1, along(0, 0.3));
  expect_follows(run, {m, kn, 2 * eta * std::sqrt(kn * m), dt}, 0, 0.3);
  const double common = 0.5 * (a + b) * std::pow(b * 0.3 / (a + b), 2);  // of the centre of mass
  run.advance(3000);
  EXPECT_NEAR(run.energies().dissipated / (run.energies().initial - common), 1, 1e-12);
}

TEST(Dashpots, CoefficientsAreThoseOfEquations9And10) {
  const Model model = pair_along_x(1000, 2000);
  const auto properties = bond_properties(model);
  const double ma = mass(model.particles[0]), mb = mass(model.particles[1]);
  const double ia = moment_of_inertia(model.particles[0]), ib = moment_of_inertia(model.particles[1]);
  const BondDamping damping{.paper = 0.1, .normal = 0.2, .shear = 0.3, .twisting = 0.4, .bending = 0.5};
  const auto expect = [&](std::vector<std::uint8_t> free, double m, double i) {
    const SectionStiffness c = dashpots(model, properties, free, damping)[0];
    EXPECT_DOUBLE_EQ(c.kn, 0.2 * std::sqrt(kn * m) + 0.4 * std::sqrt(kn * m));
    EXPECT_DOUBLE_EQ(c.ks, 0.2 * std::sqrt(kn * m) + 0.6 * std::sqrt(ks * m));
    EXPECT_DOUBLE_EQ(c.kt, 0.2 * std::sqrt(2 * kt * i) + 0.8 * std::sqrt(kt * i));
    EXPECT_DOUBLE_EQ(c.kb, 0.2 * std::sqrt(2 * kt * i) + 1.0 * std::sqrt(kb * i));
    EXPECT_EQ(c.coupling, 0);
  };
  expect({0x3f, 0x3f}, ma * mb / (ma + mb), ia * ib / (ia + ib));
  expect({0, 0x3f}, mb, ib);
  expect({0x3f, 0}, ma, ia);
  expect({0x38, 0x3f}, mb, ia * ib / (ia + ib));  // a's centre is held, it may turn
  expect({0x01, 0x07}, ma * mb / (ma + mb), 0);   // neither may turn
}

TEST(Dashpots, LeaveOutMomentsThatAreNotFedBack) {
  Model model =
      pair(block("edem-v2", {{"normal_stiffness", 3e5}, {"shear_stiffness", 1e5}, {"torque_feedback", 0}}),
           Matrix3::Identity(), 1, 0.5, 0.4);
  give_density(model, 1000);
  const std::vector<std::uint8_t> free{0x3f, 0x3f};
  const SectionStiffness c = dashpots(model, bond_properties(model), free, {.paper = 0.1, .bending = 0.1})[0];
  EXPECT_GT(c.kn, 0);
  EXPECT_GT(c.ks, 0);
  EXPECT_EQ(c.kt, 0);
  EXPECT_EQ(c.kb, 0);
}

}  // namespace
}  // namespace bondstatic::test
