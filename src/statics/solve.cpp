#include <algorithm>

#include "bondstatic/error.hpp"
#include "bondstatic/mechanism.hpp"
#include "bondstatic/statics.hpp"
#include "model/space_order.hpp"
#include "solver/machine.hpp"
#include "statics/partners.hpp"
#include "statics/static_run.hpp"

namespace bondstatic {

namespace {

// Smaller models stay in the cache whatever their order.
constexpr std::size_t worth_renumbering = 1 << 14;

std::vector<Mechanism> in_given_order(std::vector<Mechanism> mechanisms, const SpaceOrder& order) {
  for (Mechanism& mechanism : mechanisms) {
    for (Index& p : mechanism.particles) p = order.particle[std::size_t(p)];
    std::sort(mechanism.particles.begin(), mechanism.particles.end());
  }
  std::stable_sort(mechanisms.begin(), mechanisms.end(),
                   [](const Mechanism& l, const Mechanism& r) { return l.particles < r.particles; });
  return mechanisms;
}

// What is wrong is told of the model as it was given.
StaticSolution solve_renumbered(const Model& model, const Model& near, const SpaceOrder& order,
                                const StaticOptions& options, int threads) try {
  return StaticRun(near, nullptr, options).solve(false);
} catch (const MechanismError& error) {
  throw MechanismError(model, in_given_order(error.mechanisms(), order));
} catch (const InputError&) {
  bond_properties(model, threads);
  throw;
}

StaticSolution solve_in_space_order(const Model& model, const StaticOptions& options) {
  const int threads = options.threads > 0 ? options.threads : cores_at_hand();
  std::vector<Phase> phases;
  Stopwatch timed(phases, options.progress);
  SpaceOrder order;
  const Model near = timed("renumbering", [&] {
    order = space_order(model, threads);
    return renumbered(model, order, threads);
  });
  StaticSolution solution = solve_renumbered(model, near, order, options, threads);
  timed("renumbering", [&] {
    for (State& state : solution.cases) {
      restore_order(state.displacement, order.particle, threads);
      restore_order(state.reaction, order.particle, threads);
      restore_order(state.bonds, order.bond, threads);
    }
  });
  solution.report.phases.insert(solution.report.phases.begin(), phases.front());
  return solution;
}

}  // namespace

StaticSolution solve_statics(const Model& model, const StaticOptions& options) {
  if (model.particles.size() >= worth_renumbering) return solve_in_space_order(model, options);
  return StaticRun(model, nullptr, options).solve(false);
}

StaticSolution solve_statics(const Partners& partners, const StaticOptions& options) {
  return StaticRun(partners.piece.model, &partners, options).solve(false);
}

}  // namespace bondstatic
