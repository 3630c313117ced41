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

// Ranks find mechanisms in the whole model, which is in its own order.
StaticSolution solve_renumbered(const Piece& piece, const Piece& near, const Partners& partners,
                                const StaticOptions& options, int threads) try {
  const Partners there{near, partners.ranks, partners.whole};
  return StaticRun(near.model, &there, options).solve(false);
} catch (const InputError&) {
  bond_properties(piece.model, threads);
  throw;
}

// `given`: a model or a piece of one; solve(near, order, threads) answers for its renumbered copy, which is
// gone before the answer is put in order: both take memory.
template <class Given, class Solve>
StaticSolution solve_in_space_order(const Given& given, const StaticOptions& options, Solve solve) {
  const int threads = options.threads > 0 ? options.threads : cores_at_hand();
  std::vector<Phase> phases;
  Stopwatch timed(phases, options.progress);
  SpaceOrder order;
  StaticSolution solution = [&] {
    const Given near = timed("renumbering", [&] {
      order = space_order(given, threads);
      return renumbered(given, order, threads);
    });
    return solve(near, order, threads);
  }();
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
  if (!worth_renumbering(model)) return StaticRun(model, nullptr, options).solve(false);
  return solve_in_space_order(model, options, [&](const Model& near, const SpaceOrder& order, int threads) {
    return solve_renumbered(model, near, order, options, threads);
  });
}

StaticSolution solve_statics(const Partners& partners, const StaticOptions& options) {
  const Piece& piece = partners.piece;
  if (!worth_renumbering(piece.model)) return StaticRun(piece.model, &partners, options).solve(false);
  return solve_in_space_order(piece, options, [&](const Piece& near, const SpaceOrder&, int threads) {
    return solve_renumbered(piece, near, partners, options, threads);
  });
}

}  // namespace bondstatic
