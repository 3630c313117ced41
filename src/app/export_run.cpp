#include "app/export_run.hpp"

#include <algorithm>
#include <cmath>

#include "bondstatic/modes.hpp"
#include "model/boundary.hpp"

namespace bondstatic {

namespace {

constexpr double digits_to_rest = 1e-9, margin = 1.5;
constexpr double rough = 0.02;  // what is found is an upper bound of the frequency in any case
constexpr double fewest_steps = 1000, most_steps = 1e9;

/// Three digits do for a step, and are the same on every machine.
double rounded_down(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;  // nothing can move: any step will do
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::floor(value / unit) * unit;
}

double rayleigh_frequency(const Model& model, const State& state) {
  const BodyMasses masses = body_masses(model);
  double inertia = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const Vector6& u = state.displacement[p];
    if (u.allFinite())
      inertia += masses.mass[p] * u.head<3>().squaredNorm() + masses.inertia[p] * u.tail<3>().squaredNorm();
  }
  return inertia > 0 ? std::sqrt(2 * state.energy / inertia) : 0;
}

}  // namespace

RunNumbers run_numbers(const Model& model, std::span<const BondProperties> properties, const State& state,
                       const RelaxOptions& options, int threads) {
  RunNumbers run;
  run.particle_damping = options.particle_damping;
  if (run.particle_damping == 0) {
    run.particle_damping = RelaxOptions().particle_damping;
    run.remarks.push_back(
        "The case has no particle damping; the exported run has the usual one, as it would not come to "
        "rest.");
  }
  if (options.bond_damping.any())
    run.remarks.push_back(
        "The dashpots of the case's bonds are not exported; the state at rest is the same.");

  Boundary boundary = boundary_of(model, 0);
  for (std::size_t p = 0; p < boundary.free.size(); ++p)
    if (!state.displacement[p].allFinite()) boundary.free[p] = 0;
  const FreeDofs dofs = number_free_dofs(boundary.free);
  // Damping adds up to gamma times the force that stops a particle: at worst the model is stiffer by that.
  const double highest =
      highest_frequency(bond_network(model, properties), dofs, body_masses(model), threads, rough);
  const double critical = 2 / (highest * std::sqrt(1 + run.particle_damping));
  run.time_step = options.time_step > 0 ? options.time_step : rounded_down(options.safety * critical);

  const double decay = rayleigh_frequency(model, state) * particle_damping_decay(run.particle_damping);
  const double steps = decay > 0 ? margin * std::log(1 / digits_to_rest) / (decay * run.time_step) : 0;
  run.steps = Index(std::clamp(std::ceil(steps), fewest_steps, most_steps));
  return run;
}

}  // namespace bondstatic
