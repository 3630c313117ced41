#include "statics/refine.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "statics/error_estimates.hpp"
#include "statics/iterate.hpp"
#include "system/together.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

struct Rounds {
  std::vector<Iterate> iterates;
  Effort effort;
};

// Rounds of residual and correction, all load cases together, until what is left is below `enough` of the
// largest entry, by what the corrections tell.
Rounds refine(const BondNetwork& network, const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
              LinearSolver* solver, double pivot_ratio, int threads, double enough,
              const std::function<void(const std::string&)>& progress, Ranks* ranks,
              const FromBefore& before) {
  const double length = network.rotation_length;
  const bool iterative = solver && solver->iterative();
  Rounds rounds;
  auto& [iterates, effort] = rounds;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    iterates.emplace_back(network, *cases[c], threads, ranks);
    if (before.motions)
      iterates.back().begin_from((*before.motions)[c], dofs, before.came_by.empty() ? 0 : before.came_by[c]);
  }
  const auto all_done = [&] {
    return std::all_of(iterates.begin(), iterates.end(), [](const Iterate& i) { return i.done; });
  };
  for (int round = 1; solver && !all_done(); ++round) {
    Eigen::MatrixXd right_hand_sides(dofs.unknowns(), Index(cases.size()));
    touch_pages(right_hand_sides.data(), sizeof(double) * std::size_t(right_hand_sides.size()), threads);
    right_hand_sides.setZero();
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (!iterates[c].done)
        right_hand_sides.col(Index(c)) =
            iterates[c].next_residual(network, *cases[c], dofs, iterative, threads, ranks);
    const Eigen::MatrixXd corrections = solver->solve(right_hand_sides);
    for (std::size_t c = 0; c < cases.size(); ++c) {
      if (iterates[c].done) continue;
      iterates[c].add(corrections.col(Index(c)), dofs, length, threads, ranks);
      if (iterative)
        iterates[c].judge_iterative(solver->last_solve());
      else
        iterates[c].judge_direct(pivot_ratio, enough);
    }
    const SolveReport last = solver->last_solve();
    effort.iterations += last.iterations;
    if (!iterative) continue;
    if (!last.note.empty()) effort.notes.push_back(last.note);
    if (progress)
      progress(
          fmt::format("round {}: {} iterations, correction {:.0e}", round, effort.iterations,
                      iterates.front().size > 0 ? iterates.front().correction / iterates.front().size : 0));
  }
  return rounds;
}

}  // namespace

std::vector<BodyVectors<Extended>> solve_adjoint(const BondNetwork& network, const FreeDofs& dofs,
                                                 const std::vector<const Boundary*>& cases,
                                                 LinearSolver* solver, double pivot_ratio, int threads,
                                                 const FromBefore& before) {
  Rounds rounds =
      refine(network, dofs, cases, solver, pivot_ratio, threads, before.enough, nullptr, nullptr, before);
  std::vector<BodyVectors<Extended>> motions;
  for (Iterate& iterate : rounds.iterates) motions.push_back(std::move(iterate.motion));
  return motions;
}

std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver* solver, double pivot_ratio, int threads, Effort& effort,
                                   const std::function<void(const std::string&)>& progress, Ranks* ranks,
                                   const FromBefore& before) {
  const double length = network.rotation_length;
  const bool iterative = solver && solver->iterative();
  Rounds rounds = refine(network, dofs, cases, solver, pivot_ratio, threads,
                         before.motions ? before.enough : extended_rounding, progress, ranks, before);
  std::vector<Iterate>& iterates = rounds.iterates;
  effort = std::move(rounds.effort);
  Eigen::MatrixXd right_hand_sides =
      Eigen::MatrixXd::Zero(iterative ? 0 : dofs.unknowns(), Index(cases.size()));

  std::vector<BodyVectors<double>> answers;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    iterates[c].drop_negligible(dofs, length, iterative || before.motions ? iterates[c].expected : 0);
    answers.push_back(converted<double>(iterates[c].motion, threads));
    if (!iterative && !before.in_brief)
      right_hand_sides.col(Index(c)) =
          to_unknowns(rounding_forces(network, incidence, answers[c], cases[c]->strain), dofs, length);
  }
  // What an iterative solver leaves is far above the rounding of the natural form: one solve is saved.
  if (solver && !iterative && !before.in_brief) right_hand_sides = solver->solve(right_hand_sides);

  std::vector<Refined> refined(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Accuracy& accuracy = refined[c].accuracy;
    accuracy.pivot_ratio = pivot_ratio;
    accuracy.refinements = std::max(0, iterates[c].steps - 1);
    accuracy.backward_error = largest_of_all(
        ranks, backward_error(network, incidence, dofs, *cases[c], answers[c], iterates[c].size, threads));
    const double left = (iterative ? 2 : 4) * iterates[c].expected;
    const double moved =
        iterative ? 0 : largest_of_all(ranks, right_hand_sides.col(Index(c)).lpNorm<Eigen::Infinity>());
    if (iterates[c].size > 0) {
      refined[c].rounding = 4 * moved / iterates[c].size;
      accuracy.forward_error = 0x1p-53 + negligible + left / iterates[c].size + refined[c].rounding;
    }
    refined[c].motion = std::move(iterates[c].motion);
  }
  return refined;
}

}  // namespace bondstatic
