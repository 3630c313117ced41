#include "relax/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bondstatic/error.hpp"
#include "bondstatic/modes.hpp"
#include "dynamics/bodies.hpp"
#include "solver/machine.hpp"
#include "statics/refine.hpp"

namespace bondstatic {

namespace {

constexpr Index modes_told = 5;

/// Far below the digits that a time step keeps; the frequency is an upper bound in any case.
constexpr double frequency_tolerance = 1e-6;

/// Where particle_damping_decay(gamma) / sqrt(1 + gamma), the decay in a step, is largest.
constexpr double best_gamma = 0.856;

/// Three digits and no more: the last bits of a frequency may depend on threads and solver, a run must not.
double rounded_down(double value) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::floor(value / unit) * unit;
}

/// Particle damping adds up to gamma times the force that stops a particle, so that at worst the model is
/// stiffer, and its dashpots stronger, by 1 + gamma.
double step_with_dashpots(BondNetwork stiffness, BondNetwork dashpots, const FreeDofs& dofs,
                          const BodyMasses& masses, double gamma, int threads) {
  for (BondNetwork* network : {&stiffness, &dashpots})
    for (Link& link : network->links)
      for (double* k : {&link.stiffness.kn, &link.stiffness.ks, &link.stiffness.kt, &link.stiffness.kb,
                        &link.stiffness.coupling})
        *k *= 1 + gamma;
  return critical_time_step(stiffness, &dashpots, dofs, masses, threads);
}

BondNetwork dashpot_network(const PlanInput& input, const BondDamping& damping) {
  BondNetwork network = input.network;
  const auto coefficients = dashpots(input.model, input.properties, input.held.dofs.free, damping);
  for (std::size_t k = 0; k < network.links.size(); ++k) network.links[k].stiffness = coefficients[k];
  return network;
}

/// Damping ratio times frequency of a mode: half of shape^T D shape.
double viscous_decay(const BondNetwork& dashpots, const Mode& mode) {
  double power = 0;
  for (const Link& link : dashpots.links) {
    const Vector6 rate =
        relative_motion<double>(link, mode.shape[std::size_t(link.a)], mode.shape[std::size_t(link.b)]);
    power += rate.dot(resultants<double>(link.stiffness, bond_axis<double>(link), rate));
  }
  return 0.5 * power;
}

/// Slowest modes and the largest displacement of the static answer, where the factor fits.
struct Slow {
  std::vector<Mode> modes;
  double displacement = 0;
};

Slow slow_modes(const PlanInput& input, const RelaxOptions& options, const StaticOptions& solve,
                int threads) {
  const FreeDofs& dofs = input.held.dofs;
  if (dofs.unknowns() == 0) return {};
  const auto solver = make_solver(solve.solver, threads);
  const double needed = solver->analyse(input.network, dofs).predicted_bytes;
  const double limit = solve.memory_limit > 0 ? solve.memory_limit : available_memory();
  if (needed > limit) {
    if (!std::isnan(options.ramp_time) && !std::isnan(options.hold_time)) return {};
    throw MemoryError(fmt::format(
        "the slowest mode, from which ramp and hold times are taken, needs a factorisation of {:.3g} GB; "
        "{:.3g} GB are at hand\n    cure: give ramp_time and hold_time in [dynamics]",
        needed / 1e9, limit / 1e9));
  }
  const double pivots = solver->factorise(input.network, dofs).pivot_ratio;
  Slow slow;
  slow.modes = lowest_modes(input.network, dofs, body_masses(input.model), *solver, modes_told);
  Effort effort;
  const auto refined = solve_refined(input.network, link_incidence(input.network), dofs, {&input.boundary},
                                     solver.get(), pivots, threads, effort, {});
  for (const auto& motion : refined.front().motion)
    slow.displacement = std::max(slow.displacement, motion.cast<double>().head<3>().norm());
  return slow;
}

/// Of the slowest mode when the ramp ends: each corner of the ramp excites it, the first has decayed by then.
double speed_after_ramp(const DynamicPlan& plan, const RelaxOptions& options, double displacement,
                        double decay) {
  const double w = plan.lowest.front(), t = plan.ramp_time;
  const double at_once = w * displacement;
  if (!(t > 0)) return at_once;
  const double corner = options.ramp == Ramp::linear ? displacement / t : 6 * displacement / (w * t * t);
  return std::min(at_once, corner * (1 + std::exp(-decay * t)));
}

double steps_to_rest(const DynamicPlan& plan, const RelaxOptions& options, double displacement, double decay,
                     double time_step) {
  if (!(decay > 0)) return std::numeric_limits<double>::infinity();
  const double w = plan.lowest.front();
  const double slow_enough = std::min(options.velocity_limit, options.force_limit * w * displacement);
  const double speed = speed_after_ramp(plan, options, displacement, decay);
  const double dying = speed > slow_enough && slow_enough > 0 ? std::log(speed / slow_enough) / decay : 0;
  return std::ceil((plan.ramp_time + dying + plan.hold_time) / time_step);
}

}  // namespace

double particle_damping_decay(double gamma) {
  const double half_cycle = 0.5 * std::numbers::pi * (1 / std::sqrt(1 - gamma) + 1 / std::sqrt(1 + gamma));
  return 0.5 * std::log((1 + gamma) / (1 - gamma)) / half_cycle;
}

DynamicPlan plan_run(const PlanInput& input, const RelaxOptions& options, const StaticOptions& solve,
                     int threads) {
  require_masses(input.model, input.boundary, input.held.left_out);
  DynamicPlan plan;
  const FreeDofs& dofs = input.held.dofs;
  const BodyMasses masses = body_masses(input.model);
  BondNetwork damping;
  if (options.bond_damping.any()) damping = dashpot_network(input, options.bond_damping);
  const bool viscous = options.bond_damping.any();

  plan.highest = highest_frequency(input.network, dofs, masses, threads, frequency_tolerance);
  const auto critical = [&](double gamma) {
    return viscous ? step_with_dashpots(input.network, damping, dofs, masses, gamma, threads)
                   : 2 / (plan.highest * std::sqrt(1 + gamma));
  };
  plan.critical_time_step = critical(options.particle_damping);
  plan.time_step =
      options.time_step > 0 ? options.time_step : rounded_down(options.safety * plan.critical_time_step);

  if (!std::isfinite(plan.time_step)) plan.time_step = 1;  // nothing can move: any step will do

  const Slow slow = slow_modes(input, options, solve, threads);
  for (const Mode& mode : slow.modes) plan.lowest.push_back(mode.frequency);
  // Without anything that can move there is nothing to wait for.
  const double period =
      plan.lowest.empty() ? plan.time_step : rounded_down(2 * std::numbers::pi / plan.lowest.front());
  plan.ramp_time = std::isnan(options.ramp_time) ? period : options.ramp_time;
  plan.hold_time = std::isnan(options.hold_time) ? period : options.hold_time;
  if (plan.lowest.empty()) return plan;

  const double slowest = plan.lowest.front();
  const double by_bonds = viscous ? viscous_decay(damping, slow.modes.front()) : 0;
  plan.decay = slowest * particle_damping_decay(options.particle_damping) + by_bonds;
  plan.best_particle_damping = best_gamma;
  plan.best_decay = slowest * particle_damping_decay(best_gamma) + by_bonds;
  plan.speed = speed_after_ramp(plan, options, slow.displacement, plan.decay);
  plan.predicted_steps = steps_to_rest(plan, options, slow.displacement, plan.decay, plan.time_step);
  plan.best_predicted_steps =
      steps_to_rest(plan, options, slow.displacement, plan.best_decay, options.safety * critical(best_gamma));
  return plan;
}

}  // namespace bondstatic
