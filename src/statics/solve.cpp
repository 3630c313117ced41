// The static solve told as numbered steps.
#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "bondstatic/statics.hpp"
#include "solver/machine.hpp"
#include "statics/choose.hpp"
#include "statics/effective_stiffness.hpp"
#include "statics/held.hpp"
#include "statics/held_on_ranks.hpp"
#include "statics/partners.hpp"
#include "statics/recover.hpp"
#include "statics/stopwatch.hpp"
#include "system/together.hpp"

namespace bondstatic {

namespace {

// Load cases that hold the same degrees of freedom share one factorisation.
struct Group {
  std::vector<std::size_t> cases;
  Held held;
};

std::vector<Group> group_by_supports(const std::vector<Boundary>& boundaries, Ranks* ranks) {
  std::vector<Index> label;  // of each case: the first case that holds the same
  for (std::size_t c = 0; c < boundaries.size(); ++c) {
    std::size_t first = 0;
    while (boundaries[first].free != boundaries[c].free) ++first;
    label.push_back(Index(first));
  }
  if (ranks) label = common_labels(*ranks, label);
  std::vector<Group> groups;
  for (std::size_t c = 0; c < label.size(); ++c) {
    const auto same = [&](const Group& g) { return label[g.cases.front()] == label[c]; };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) group = groups.insert(groups.end(), Group{});
    group->cases.push_back(c);
  }
  return groups;
}

std::string unknown_name(const Model& model, const FreeDofs& dofs, Index unknown) {
  std::size_t p = 0;
  while (dofs.first[p + 1] <= unknown) ++p;
  return fmt::format("particle {}", model.particles[p].id);
}

void check_pivots(const Model& model, const FreeDofs& dofs, const FactorReport& factor) {
  // A pivot below the rounding of its own diagonal entry is rounding itself.
  if (factor.pivot_ratio > 0x1p-53) return;
  const std::string where = factor.broken_at >= 0 ? " at " + unknown_name(model, dofs, factor.broken_at) : "";
  throw AccuracyError(fmt::format(
      "the stiffness matrix is numerically singular: the factorisation broke down{} (pivot ratio {:.1e})\n"
      "    cure: look for stiffness that differs by more than 15 decades between bonds, or for slender parts "
      "that "
      "are almost a mechanism",
      where, factor.pivot_ratio));
}

// Factorises and refines the load cases of a group.
std::vector<Refined> solved(const Model& model, const BondNetwork& network, const Incidence& incidence,
                            const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                            LinearSolver* solver, const StaticOptions& options, Ranks* ranks,
                            Stopwatch& timed, StaticReport& report) {
  const bool iterative = solver && solver->iterative();
  FactorReport factor;
  if (solver) {
    factor = timed(iterative ? "set-up" : "factorisation", [&] { return solver->factorise(network, dofs); });
    ++report.factorisations;
    check_pivots(model, dofs, factor);
  }
  Effort effort;
  auto refined = timed(iterative ? "iterations" : "refinement", [&] {
    return solve_refined(network, incidence, dofs, cases, solver, factor.pivot_ratio, report.threads, effort,
                         options.progress, ranks);
  });
  report.iterations = std::max(report.iterations, effort.iterations);
  for (const std::string& note : effort.notes) report.warnings.push_back(report.solver + " " + note);
  return refined;
}

// `partners`: null where the model is all of it.
StaticSolution solve(const Model& model, const Partners* partners, const StaticOptions& options) {
  Ranks* const ranks = ranks_of(partners);
  StaticSolution solution;
  StaticReport& report = solution.report;
  Stopwatch timed(report.phases, options.progress);
  report.threads_asked = options.threads > 0 ? options.threads : cores_at_hand();
  report.threads = options.yield_cores ? threads_worth_having(report.threads_asked) : report.threads_asked;
  report.solver = options.solver == "auto" ? available_solvers().front().name : options.solver;

  // 1. What each bond is: C, contact point, section.
  const auto properties = timed("bonds", [&] { return bond_properties(model, report.threads); });
  BondNetwork network = bond_network(model, properties);
  NetworkShare share;
  if (partners) {
    share = share_of(partners->piece, *ranks);
    network.share = &share;
    network.rotation_length = rotation_length_of_all(network, *ranks);
  }
  const Incidence incidence = link_incidence(network);

  // 2. What is held and what is loaded, one boundary a load case; cases with the same supports go together.
  std::vector<Boundary> boundaries;
  for (std::size_t c = 0; c < model.load_cases.size(); ++c)
    boundaries.push_back(boundary_of(model, Index(c)));
  std::vector<Group> groups = group_by_supports(boundaries, ranks);
  solution.cases.resize(boundaries.size());

  for (Group& group : groups) {
    // 3. Motions that cost no energy never reach the solver.
    const auto& free = boundaries[group.cases.front()].free;
    group.held = timed("mechanisms", [&] {
      if (partners)
        return held_on_ranks(*partners, network, free, Index(group.cases.front()), options.unsupported);
      return held_by(model, network, free, options.unsupported);
    });
    const FreeDofs& dofs = group.held.dofs;
    report.dropped.insert(report.dropped.end(), group.held.dropped.begin(), group.held.dropped.end());
    for (const std::size_t c : group.cases) {
      const std::string lost = lost_loads(network, group.held, boundaries[c], model.load_cases[c], ranks);
      if (!lost.empty()) report.warnings.push_back(lost);
    }

    // 4. Choose a solver; order and predict, so that what does not fit ends before it is begun.
    Chosen chosen;
    if (largest_of_all(ranks, double(dofs.unknowns())) > 0) {
      chosen = timed("analysis", [&] { return choose(network, incidence, dofs, options, report.threads); });
      if (chosen.analysis.factor_entries >= report.analysis.factor_entries) {
        report.analysis = chosen.analysis;
        report.solver = chosen.name;
        report.solver_reason = chosen.reason;
      }
    }

    // 5. Factorise, solve and refine until the last digit stands.
    std::vector<const Boundary*> loads;
    for (const std::size_t c : group.cases) loads.push_back(&boundaries[c]);
    std::vector<Refined> refined;
    const auto solve_by = [&](Chosen& by) {
      refined =
          solved(model, network, incidence, dofs, loads, by.solver.get(), options, ranks, timed, report);
    };
    try {
      solve_by(chosen);
    } catch (const AccuracyError&) {
      if (chosen.reason.empty() || !chosen.solver->iterative()) throw;
      chosen.solver.reset();
      Chosen direct =
          timed("analysis", [&] { return choose_direct(network, dofs, options, report.threads); });
      if (!direct.solver) throw;
      report.warnings.push_back(chosen.name + " did not converge; " + direct.name + " took over");
      report.analysis = direct.analysis;
      report.solver = direct.name;
      report.solver_reason = direct.name + ": " + chosen.name + " did not converge";
      solve_by(direct);
    }
    chosen.solver.reset();  // recovery needs memory, too

    // 6. Reactions, resultants, energy, balances.
    timed("recovery", [&] {
      for (std::size_t i = 0; i < group.cases.size(); ++i) {
        LoadCaseResult& result = solution.cases[group.cases[i]];
        result = recover(model, network, incidence, properties, *loads[i], group.held.left_out, refined[i],
                         report.threads, ranks);
        result.name = model.load_cases[group.cases[i]];
        if (!(result.accuracy.backward_error <= options.tolerance))
          throw AccuracyError(
              fmt::format("the backward error {:.2e} is above the asked {:.2e}\n    cure: ask for less "
                          "([solve] tolerance), or look for a part that is almost a mechanism",
                          result.accuracy.backward_error, options.tolerance));
      }
    });
  }
  // 7. A periodic cell's stresses under six strains are its stiffness.
  solution.effective =
      effective_stiffness(model, network, boundaries, groups.front().held.left_out, solution);

  // What several groups of load cases leave out is said once.
  std::sort(report.dropped.begin(), report.dropped.end());
  report.dropped.erase(std::unique(report.dropped.begin(), report.dropped.end()), report.dropped.end());
  report.peak_bytes = largest_of_all(ranks, peak_resident_memory());
  return solution;
}

}  // namespace

StaticSolution solve_statics(const Model& model, const StaticOptions& options) {
  return solve(model, nullptr, options);
}

StaticSolution solve_statics(const Partners& partners, const StaticOptions& options) {
  return solve(partners.piece.model, &partners, options);
}

}  // namespace bondstatic
