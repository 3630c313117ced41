// The static solve told as numbered steps.
#include "statics/static_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "bondstatic/error.hpp"
#include "solver/machine.hpp"
#include "statics/acceptance.hpp"
#include "statics/adjoint.hpp"
#include "statics/effective_stiffness.hpp"
#include "statics/held_on_ranks.hpp"
#include "statics/recover.hpp"
#include "system/together.hpp"

namespace bondstatic {

namespace {

// What is left of an answer, of its largest entry, where a solve goes on: one that is rounded to double is
// then the same whatever order sums were taken in, but for one digit in a thousand million.
constexpr double far_below_last_digit = 0x1p-80;

/// The same pattern of K, and the same mechanisms.
bool alike(const Link& l, const Link& r) {
  const auto resists = [](const SectionStiffness& c) {
    return std::array{c.kn > 0, c.ks > 0, c.kt > 0, c.kb > 0, c.full_rank()};
  };
  return l.a == r.a && l.b == r.b && l.branch == r.branch && l.fraction == r.fraction &&
         resists(l.stiffness) == resists(r.stiffness);
}

}  // namespace

StaticRun::StaticRun(const Model& model, const Partners* partners, const StaticOptions& options)
    : model_(model), partners_(partners), options_(options), ranks_(ranks_of(partners)) {}

bool StaticRun::goes_on(const BondNetwork& network, const std::vector<Boundary>& boundaries) const {
  return std::equal(network.links.begin(), network.links.end(), network_.links.begin(), network_.links.end(),
                    alike) &&
         std::equal(boundaries.begin(), boundaries.end(), boundaries_.begin(), boundaries_.end(),
                    [](const Boundary& l, const Boundary& r) { return l.free == r.free; });
}

std::vector<StaticRun::Group> StaticRun::group_by_supports() const {
  std::vector<Index> label;  // of each case: the first case that holds the same
  for (std::size_t c = 0; c < boundaries_.size(); ++c) {
    std::size_t first = 0;
    while (boundaries_[first].free != boundaries_[c].free) ++first;
    label.push_back(Index(first));
  }
  if (ranks_) label = common_labels(*ranks_, label);
  std::vector<Group> groups;
  for (std::size_t c = 0; c < label.size(); ++c) {
    const auto same = [&](const Group& g) { return label[g.cases.front()] == label[c]; };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end()) group = groups.insert(groups.end(), Group{});
    group->cases.push_back(c);
  }
  return groups;
}

void StaticRun::prepare(Group& group, bool keep, Stopwatch& timed) const {
  // 3. Motions that cost no energy never reach the solver.
  const auto& free = boundaries_[group.cases.front()].free;
  group.held = timed("mechanisms", [&] {
    if (partners_)
      return held_on_ranks(*partners_, network_, free, Index(group.cases.front()), options_.unsupported);
    return held_by(model_, network_, free, options_.unsupported);
  });

  // 4. Choose a solver; order and predict, so that what does not fit ends before it is begun.
  const FreeDofs& dofs = group.held.dofs;
  const int solves = keep ? 3 : 1;  // the state, its derivatives, the next state
  if (largest_of_all(ranks_, double(dofs.unknowns())) > 0)
    group.chosen =
        timed("analysis", [&] { return choose(network_, incidence_, dofs, options_, threads_, solves); });

  // A direct solver of our own, which tells what its factor takes, may answer for the next numbers, too.
  Chosen& chosen = group.chosen;
  if (!keep || !chosen.solver || !(chosen.analysis.factor_flops > 0)) return;
  const DirectRates& rates = chosen.name == "cholmod" ? cholmod_rates : eigen_rates;
  auto kept = std::make_unique<KeptFactor>(std::move(chosen.solver), chosen.analysis, rates, threads_);
  group.kept = kept.get();
  chosen.solver = std::move(kept);
}

// Factorises and refines the load cases of a group.
std::vector<Refined> StaticRun::factorise_and_refine(Group& group, const std::vector<const Boundary*>& loads,
                                                     const std::vector<BodyVectors<Extended>>& start,
                                                     Stopwatch& timed, StaticReport& report) const {
  LinearSolver* const solver = group.chosen.solver.get();
  const FreeDofs& dofs = group.held.dofs;
  const bool iterative = solver && solver->iterative();
  FactorReport factor;
  if (solver) {
    factor = timed(iterative ? "set-up" : "factorisation", [&] { return solver->factorise(network_, dofs); });
    check_pivots(model_, dofs, factor);
  }
  group.pivot_ratio = factor.pivot_ratio;
  Effort effort;
  const bool in_brief = !start.empty() && !group.rounding.empty();
  auto refined = timed(iterative ? "iterations" : "refinement", [&] {
    return solve_refined(
        network_, incidence_, dofs, loads, solver, factor.pivot_ratio, threads_, effort, options_.progress,
        ranks_,
        {.motions = start.empty() ? nullptr : &start, .enough = far_below_last_digit, .in_brief = in_brief});
  });
  if (!in_brief) group.rounding.clear();
  for (std::size_t i = 0; i < refined.size(); ++i)
    if (in_brief)
      refined[i].accuracy.forward_error += group.rounding[i];
    else
      group.rounding.push_back(refined[i].rounding);
  if (solver && !(group.kept && group.kept->kept())) ++report.factorisations;
  report.iterations = std::max(report.iterations, effort.iterations);
  for (const std::string& note : effort.notes) report.warnings.push_back(group.chosen.name + " " + note);
  return refined;
}

std::string StaticRun::reason_of(const Group& group) {
  if (!group.kept || !group.kept->kept()) return group.chosen.reason;
  return fmt::format(
      "{}: on the factor of an earlier solve, from which stiffness differs by factors within {:.3g}",
      group.chosen.name, group.kept->kept()->spread());
}

std::vector<Refined> StaticRun::solved(Group& group, const std::vector<const Boundary*>& loads,
                                       const std::vector<BodyVectors<Extended>>& start, Stopwatch& timed,
                                       StaticReport& report) const {
  Chosen& chosen = group.chosen;
  try {
    return factorise_and_refine(group, loads, start, timed, report);
  } catch (const AccuracyError&) {
    if (chosen.reason.empty() || !chosen.solver->iterative()) throw;
    chosen.solver.reset();
    group.kept = nullptr;
    Chosen direct =
        timed("analysis", [&] { return choose_direct(network_, group.held.dofs, options_, threads_); });
    if (!direct.solver) throw;
    report.warnings.push_back(chosen.name + " did not converge; " + direct.name + " took over");
    direct.reason = direct.name + ": " + chosen.name + " did not converge";
    chosen = std::move(direct);
  }
  return factorise_and_refine(group, loads, start, timed, report);
}

StaticSolution StaticRun::solve(bool keep) {
  StaticSolution solution;
  StaticReport& report = solution.report;
  Stopwatch timed(report.phases, options_.progress);
  const bool again = std::exchange(kept_, false);
  report.threads_asked = options_.threads > 0 ? options_.threads : cores_at_hand();
  // Looking takes as long as a small solve: those that go on keep what the first one found.
  if (!again)
    threads_ = options_.yield_cores ? threads_worth_having(report.threads_asked) : report.threads_asked;
  report.threads = threads_;
  report.solver = options_.solver == "auto" ? available_solvers().front().name : options_.solver;

  // 1. What each bond is: C, contact point, section.
  properties_ = timed("bonds", [&] { return bond_properties(model_, threads_); });
  BondNetwork network = bond_network(model_, properties_, threads_);
  if (partners_) {
    share_ = share_of(partners_->piece, *ranks_);
    network.share = &share_;
    network.rotation_length = rotation_length_of_all(network, *ranks_);
  }

  // 2. What is held and what is loaded, one boundary a load case; cases with the same supports go together.
  std::vector<Boundary> boundaries;
  for (std::size_t c = 0; c < model_.load_cases.size(); ++c)
    boundaries.push_back(boundary_of(model_, Index(c)));
  const bool on_the_same_analysis = again && goes_on(network, boundaries);
  network_ = std::move(network);
  boundaries_ = std::move(boundaries);
  if (!on_the_same_analysis) {
    incidence_ = link_incidence(network_);
    groups_ = group_by_supports();
  }
  solution.cases.resize(boundaries_.size());
  auto before = std::exchange(motions_, {});
  if (!on_the_same_analysis) before.clear();
  motions_.resize(keep ? boundaries_.size() : 0);

  for (Group& group : groups_) {
    if (!on_the_same_analysis) prepare(group, keep, timed);  // steps 3 and 4
    report.dropped.insert(report.dropped.end(), group.held.dropped.begin(), group.held.dropped.end());
    for (const std::size_t c : group.cases) {
      const std::string lost = lost_loads(network_, group.held, boundaries_[c], model_.load_cases[c], ranks_);
      if (!lost.empty()) report.warnings.push_back(lost);
    }

    // 5. Factorise, solve and refine until the last digit stands.
    std::vector<const Boundary*> loads;
    std::vector<BodyVectors<Extended>> start;  // of those that go on: what they ended at
    for (const std::size_t c : group.cases) {
      loads.push_back(&boundaries_[c]);
      if (!before.empty()) start.push_back(std::move(before[c]));
    }
    std::vector<Refined> refined = solved(group, loads, start, timed, report);
    if (!group.chosen.name.empty() &&
        group.chosen.analysis.factor_entries >= report.analysis.factor_entries) {
      report.analysis = group.chosen.analysis;
      report.solver = group.chosen.name;
      report.solver_reason = reason_of(group);
    }
    if (!keep) {
      group.chosen.solver.reset();
      give_back_freed_memory();  // recovery needs some, too
    }

    // 6. Reactions, resultants, energy, balances.
    timed("recovery", [&] {
      for (std::size_t i = 0; i < group.cases.size(); ++i) {
        const std::size_t c = group.cases[i];
        LoadCaseResult& result = solution.cases[c];
        result = recover(model_, network_, incidence_, properties_, *loads[i], group.held.left_out,
                         refined[i], threads_, ranks_);
        result.name = model_.load_cases[c];
        check_backward_error(result.accuracy.backward_error, options_.tolerance);
        if (keep) motions_[c] = std::move(refined[i].motion);
      }
    });
  }
  // 7. A periodic cell's stresses under six strains are its stiffness.
  solution.effective =
      effective_stiffness(model_, network_, boundaries_, groups_.front().held.left_out, solution);

  // What several groups of load cases leave out is said once.
  for (std::vector<Index>& body : report.dropped) std::sort(body.begin(), body.end());
  std::sort(report.dropped.begin(), report.dropped.end());
  report.dropped.erase(std::unique(report.dropped.begin(), report.dropped.end()), report.dropped.end());
  report.peak_bytes = largest_of_all(ranks_, peak_resident_memory());
  kept_ = keep;
  return solution;
}

std::vector<BondGradients> StaticRun::gradients(const std::vector<Functionals>& scalars) {
  if (!kept_) throw std::logic_error("gradients: the last solve did not end well, or kept nothing");
  struct Task {
    std::size_t scalar;
    const Functional* functional;
  };
  constexpr std::size_t at_once = 16;  // extended motions of so many are small beside the factor
  std::vector<BondGradients> gradients(scalars.size(), BondGradients(network_.links.size()));
  for (Group& group : groups_) {
    std::vector<Task> tasks;
    for (std::size_t s = 0; s < scalars.size(); ++s)
      for (const Functional& functional : scalars[s])
        if (std::count(group.cases.begin(), group.cases.end(), std::size_t(functional.load_case)))
          tasks.push_back({s, &functional});
    const auto state_of = [&](const Task& task) {
      const auto c = std::size_t(task.functional->load_case);
      return SolvedState{motions_[c], boundaries_[c].strain, group.held.dofs.free, group.held.left_out};
    };
    for (std::size_t first = 0; first < tasks.size(); first += at_once) {
      const std::size_t count = std::min(at_once, tasks.size() - first);
      std::vector<LinkWeights> weights;
      std::vector<Boundary> boundaries;
      std::vector<const Boundary*> loads;
      std::vector<std::optional<Extended>> multiples;
      for (std::size_t t = first; t < first + count; ++t) {
        const SolvedState state = state_of(tasks[t]);
        weights.push_back(link_weights(model_, network_, *tasks[t].functional, state));
        boundaries.push_back(
            adjoint_boundary(network_, properties_, *tasks[t].functional, weights.back(), state));
      }
      for (std::size_t i = 0; i < count; ++i) {
        const auto c = std::size_t(tasks[first + i].functional->load_case);
        multiples.push_back(multiple_of(boundaries_[c], boundaries[i]));
        if (!multiples.back()) loads.push_back(&boundaries[i]);
      }
      FromBefore before;
      if (first == 0 && group.kept && group.kept->kept() && group.adjoints.size() == loads.size())
        before = {.motions = &group.adjoints, .enough = far_below_last_digit};
      auto solved_for = solve_adjoint(network_, group.held.dofs, loads, group.chosen.solver.get(),
                                      group.pivot_ratio, threads_, before);
      auto next = solved_for.begin();
      for (std::size_t i = 0; i < count; ++i) {
        const Task& task = tasks[first + i];
        const SolvedState state = state_of(task);
        const BodyVectors<Extended> adjoint = multiples[i] ? times(*multiples[i], state.motion) : *next++;
        add_gradient(network_, properties_, *task.functional, weights[i], state, adjoint, threads_,
                     gradients[task.scalar]);
      }
      if (first == 0) group.adjoints = std::move(solved_for);
    }
  }
  return gradients;
}

}  // namespace bondstatic
