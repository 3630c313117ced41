// Central differences: frequencies against the eigenproblem, order of the error, balance of energies.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "bondstatic/modes.hpp"
#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

DynamicOptions undamped(Kinematics kinematics, double dt) {
  DynamicOptions options;
  options.kinematics = kinematics;
  options.particle_damping = 0;
  options.time_step = dt;
  return options;
}

double energy_left(const ExplicitRun& run) {
  return run.energies().balance();
}

/// A skew cantilever with uneven masses and its lowest modes.
struct Cantilever {
  Model model;
  BodyMasses masses;
  std::vector<Mode> modes;
  double critical = 0;

  Cantilever() {
    model = chain(block("timoshenko", {{"young", 1e8}, {"poisson", 0.3}, {"radius", 0.15}}), Vector3::Zero(),
                  Vector3(1.8, 1.92, 1.44), 6, 0.2);
    for (std::size_t p = 0; p < model.particles.size(); ++p)
      model.particles[p].density = 1500 + 200 * double(p);
    const BondNetwork network = bond_network(model, bond_properties(model));
    std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
    free[0] = 0;
    const FreeDofs dofs = number_free_dofs(std::move(free));
    masses = body_masses(model);
    const auto solver = make_solver("auto", 1);
    solver->analyse(network, dofs);
    solver->factorise(network, dofs);
    modes = lowest_modes(network, dofs, masses, *solver, 5);
    critical = critical_time_step(network, nullptr, dofs, masses, 1);
  }

  double coordinate(const Mode& mode, const std::vector<Vector6>& motion) const {
    double sum = 0;
    for (std::size_t p = 0; p < motion.size(); ++p)
      sum += masses.mass[p] * mode.shape[p].head<3>().dot(motion[p].head<3>()) +
             masses.inertia[p] * mode.shape[p].tail<3>().dot(motion[p].tail<3>());
    return sum;
  }
};

/// Angular frequencies of a run after a kick that excites all modes. Each modal coordinate is a sine
/// q(n) = A sin(n w dt) however coarse the steps, so that q(n+k) + q(n-k) = 2 cos(k w dt) q(n); fitted by
/// least squares over the series, with k near a quarter period.
std::vector<double> frequencies_of_run(const Cantilever& beam, double dt) {
  ExplicitRun run = explicit_run(beam.model, undamped(Kinematics::small, dt));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> some(0.5, 1);
  for (std::size_t p = 1; p < beam.model.particles.size(); ++p) {
    Vector6 kick = Vector6::Zero();
    for (const Mode& mode : beam.modes) kick += some(random) * mode.shape[p];
    kick[0] += 0.01 * some(random);
    run.set_velocity(Index(p), kick);
  }
  const auto steps = std::size_t(8 * std::numbers::pi / (beam.modes[0].frequency * dt));
  std::vector<std::vector<double>> q(beam.modes.size());
  for (std::size_t n = 0; n < steps; ++n) {
    const std::vector<Vector6> motion = run.state().displacement;
    for (std::size_t m = 0; m < q.size(); ++m) q[m].push_back(beam.coordinate(beam.modes[m], motion));
    run.advance(1);
  }
  std::vector<double> found;
  for (std::size_t m = 0; m < q.size(); ++m) {
    const auto k = std::size_t(std::lround(std::numbers::pi / (2 * beam.modes[m].frequency * dt)));
    double product = 0, square = 0;
    for (std::size_t n = k; n + k < q[m].size(); ++n) {
      product += q[m][n] * (q[m][n + k] + q[m][n - k]);
      square += 2 * q[m][n] * q[m][n];
    }
    found.push_back(std::acos(product / square) / (double(k) * dt));
  }
  return found;
}

TEST(Scheme, CantileverVibratesAtTheFrequenciesOfTheEigenproblem) {
  const Cantilever beam;
  const double dt = 0.9 * beam.critical;
  const std::vector<double> found = frequencies_of_run(beam, dt), half = frequencies_of_run(beam, dt / 2);
  for (std::size_t m = 0; m < found.size(); ++m) {
    SCOPED_TRACE("mode " + std::to_string(m));
    const double w = beam.modes[m].frequency;
    const auto dispersed = [w](double step) { return 2 / step * std::asin(w * step / 2); };
    EXPECT_NEAR(found[m] / dispersed(dt), 1, 1e-13);
    EXPECT_NEAR(half[m] / dispersed(dt / 2), 1, 1e-13);
    const double error = found[m] / w - 1, halved = half[m] / w - 1;
    EXPECT_GT(error / halved, 3.9);
    EXPECT_LT(error / halved, 4.1);
  }
}

/// Loads, moved supports and a packing with several laws.
Model driven_packing(int edge) {
  std::mt19937_64 random(23);
  Model model = random_packing(
      random, edge,
      block("edem-v2", {{"normal_stiffness", 4e9}, {"shear_stiffness", 2e9}, {"torque_feedback", 0}}));
  give_density(model, 2500);
  for (Index p = 0; p < edge * edge; ++p) fix_all(model, p);
  const Index last = Index(model.particles.size()) - 1;
  fix_all(model, last - 1, vector6(1e-4, 2e-4, -1e-4, 1e-4, 0, -2e-4));
  hold(model, last - 2, "xv", vector6(-1e-4, 0, 0, 0, 2e-4, 0));
  load(model, last, vector6(1e4, -2e4, 3e4, 1e3, 2e3, 3e3));
  load(model, last - 2, vector6(1e4, 1e4, 1e4));  // partly on a moved degree of freedom
  return model;
}

double step_for(const Model& model, double share) {
  const BondNetwork network = bond_network(model, bond_properties(model));
  const std::vector<std::uint8_t> free(model.particles.size(), 0x3f);  // all free: never above the true limit
  return share * critical_time_step(network, nullptr, number_free_dofs(free), body_masses(model), 1);
}

class Balance : public ::testing::TestWithParam<std::tuple<double, double, Ramp>> {};

TEST_P(Balance, IsRoundingWhereKinematicsAreSmall) {
  const auto& [gamma, eta, ramp] = GetParam();
  const Model model = driven_packing(3);
  DynamicOptions options = undamped(Kinematics::small, step_for(model, eta > 0 ? 0.4 : 0.7));
  options.particle_damping = gamma;
  options.bond_damping = {.normal = eta, .shear = 0.5 * eta, .twisting = 2 * eta, .bending = eta};
  options.ramp = ramp;
  options.ramp_time = 3000.5 * options.time_step;  // ends within a step
  options.load_factor = 0.7;
  ExplicitRun run = explicit_run(model, options);
  run.set_velocity(20, vector6(0.1, -0.2, 0.3, 0.4, 0.5, 0.6));
  const int looks = full_run() ? 200 : 20;
  double worst = 0;
  for (int look = 0; look <= looks; ++look) {
    worst = std::max(worst, energy_left(run));
    run.advance(look == 0 ? 1 : 5000);
  }
  RecordProperty("balance", std::to_string(1e15 * worst) + "e-15");
  EXPECT_LT(worst, 2e-14);
  const Energies e = run.energies();
  EXPECT_GT(std::abs(e.work), 0.0);
  EXPECT_EQ(e.dissipated > 0, gamma > 0 || eta > 0);
}

INSTANTIATE_TEST_SUITE_P(Scheme, Balance,
                         ::testing::Values(std::tuple{0.0, 0.0, Ramp::linear},
                                           std::tuple{0.0, 0.0, Ramp::smooth},
                                           std::tuple{0.3, 0.0, Ramp::smooth},
                                           std::tuple{0.0, 0.05, Ramp::linear},
                                           std::tuple{0.01, 0.01, Ramp::smooth}));

TEST(Scheme, BalanceIsOfSecondOrderInTheStepWhereKinematicsAreFinite) {
  Cantilever beam;
  load(beam.model, 6, vector6(0, -2e4, 1e4, 0, 3e3, 0));
  fix_all(beam.model, 3, vector6(0.1, 0, 0.2, 0, 0, 0.3));
  for (const double eta : {0.0, 0.05}) {
    SCOPED_TRACE(eta);
    const auto worst = [&](double share) {
      DynamicOptions options = undamped(Kinematics::finite, share * beam.critical);
      options.bond_damping.paper = eta;
      options.ramp = Ramp::smooth;
      options.ramp_time = 0.05;
      ExplicitRun run = explicit_run(beam.model, options);
      double left = 0;
      while (run.time() < 0.1) {
        run.advance(1);
        const Energies e = run.energies();
        left =
            std::max(left, std::abs(e.kinetic - e.held_back + e.strain + e.dissipated - e.work - e.initial));
      }
      return left;
    };
    const double coarse = worst(0.2), fine = worst(0.1);
    EXPECT_NEAR(coarse / fine, 4, 0.2);
  }
}

}  // namespace
}  // namespace bondstatic::test
