#include "fracture/damaged_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "solver/cost_model.hpp"
#include "statics/acceptance.hpp"
#include "statics/choose.hpp"
#include "statics/held.hpp"
#include "statics/refine.hpp"

namespace bondstatic {

namespace {

// Bytes a second that a product with many columns takes from memory on one thread.
constexpr double stream = 8e9;

void must_hold_the_same(const Model& model, const Boundary& held, const Boundary& scaled) {
  for (std::size_t p = 0; p < held.free.size(); ++p)
    if (held.free[p] != scaled.free[p])
      throw Error(
          ExitCode::invalid_input,
          fmt::format("the preload and the pattern that scales hold different degrees of freedom of particle "
                      "{}\n    cure: supports of both must hold the same; let those that do not move have "
                      "the value 0",
                      model.particles[p].id));
}

/// A new factorisation pays once the products with the columns gathered so far have taken as long: of r
/// columns, r / 6 breaks, each with six products; and they take no more than a quarter of the factor's
/// memory. Of each column, a tenth or so is there.
Index worthwhile_rank(const AnalysisReport& analysis) {
  const double factorisation = analysis.factor_flops * cholmod_rates.per_flop +
                               double(analysis.factor_entries) * cholmod_rates.per_factor_entry;
  const double unknowns = double(analysis.unknowns), per_column = 6 * 0.1 * 8 * unknowns / stream;
  const double breaks = std::sqrt(2 * factorisation / (6 * per_column));
  const double memory = double(analysis.factor_entries) / (4 * 0.1 * std::max(1.0, unknowns));
  return Index(std::max(6.0, std::min({6 * breaks, memory, unknowns / 4})));
}

}  // namespace

DamagedModel::DamagedModel(const Model& model, const FractureOptions& options, const StaticOptions& solve,
                           int threads, FractureReport& report)
    : report_(report),
      model_(model),
      solve_(solve),
      threads_(threads),
      properties_(bond_properties(model, threads)),
      network_(bond_network(model, properties_)),
      incidence_(link_incidence(network_)),
      scaled_(boundary_of(model, options.pattern)),
      gone_(model.bonds.size(), false),
      motions_(2) {
  const std::size_t bodies = model.particles.size();
  preloaded_ = options.preload >= 0;
  if (preloaded_)
    held_ = boundary_of(model, options.preload);
  else
    held_ = {scaled_.free, std::vector<Vector6>(bodies, Vector6::Zero()),
             std::vector<Vector6>(bodies, Vector6::Zero())};
  must_hold_the_same(model, held_, scaled_);
  for (const Link& link : network_.links) normal_stiffness_.push_back(link.stiffness.kn);
  path_ = std::make_unique<LoadPath>(network_, held_, scaled_);

  say("mechanisms");
  Held found = held_by(model, network_, scaled_.free, solve.unsupported);
  for (const Index load_case : {options.preload, options.pattern}) {
    if (load_case < 0) continue;
    const std::string lost = lost_loads(network_, found, load_case == options.pattern ? scaled_ : held_,
                                        model.load_cases[std::size_t(load_case)]);
    if (!lost.empty()) report_.first.warnings.push_back(lost);
  }
  report_.first.dropped = found.dropped;
  left_out_.assign(bodies, false);
  for (std::size_t p = 0; p < bodies; ++p)
    if (found.left_out[p]) leave_out(Index(p));
  dofs_ = std::move(found.dofs);

  report_.analyses = 1;
  analysed_ = true;
  if (dofs_.unknowns() == 0) return;
  say("analysis");
  // Of many solves on one pattern a direct solver is done first wherever it fits.
  Chosen chosen;
  if (solve.solver == "auto") chosen = choose_direct(network_, dofs_, solve, threads);
  if (!chosen.solver) chosen = choose(network_, incidence_, dofs_, solve, threads);
  report_.first.solver = chosen.name;
  report_.first.solver_reason = chosen.reason;
  report_.first.analysis = chosen.analysis;
  most_rank_ = worthwhile_rank(chosen.analysis);
  if (!chosen.solver->has_halves()) {
    solver_ = std::move(chosen.solver);
  } else {
    auto low_rank = std::make_unique<LowRankSolver>(std::move(chosen.solver));
    low_rank_ = low_rank.get();
    solver_ = std::move(low_rank);
  }
}

void DamagedModel::leave_out(Index particle) {
  const auto p = std::size_t(particle);
  left_out_[p] = true;
  for (Boundary* boundary : {&held_, &scaled_}) {
    boundary->load[p].setZero();
    boundary->prescribed[p].setZero();
  }
  for (auto& motion : motions_)
    if (!motion.empty()) motion[p] = Vector6T<Extended>::Zero();
}

void DamagedModel::refresh() {
  if (fresh_ || !solver_) return;
  if (!analysed_) {
    report_.first.analysis = solver_->analyse(network_, dofs_);
    most_rank_ = worthwhile_rank(report_.first.analysis);
    ++report_.analyses;
    analysed_ = true;
  }
  const FactorReport factor = solver_->factorise(network_, dofs_);
  ++report_.factorisations;
  check_pivots(model_, dofs_, factor);
  pivot_ratio_ = factor.pivot_ratio;
  fresh_ = true;
}

void DamagedModel::refine(std::vector<double> came_by) {
  std::vector<const Boundary*> loads{&scaled_};
  std::vector<BodyVectors<Extended>> start{std::move(motions_[1])};
  if (preloaded_) {
    loads.push_back(&held_);
    start.push_back(std::move(motions_[0]));
  }
  Effort effort;
  const bool anew = start.front().empty();
  auto refined = solve_refined(
      network_, incidence_, dofs_, loads, solver_.get(), pivot_ratio_, threads_, effort, nullptr, nullptr,
      {.motions = anew ? nullptr : &start, .came_by = std::move(came_by), .in_brief = !anew});
  accuracy_ = refined.front().accuracy;
  for (const Refined& r : refined) {
    accuracy_.backward_error = std::max(accuracy_.backward_error, r.accuracy.backward_error);
    accuracy_.forward_error = std::max(accuracy_.forward_error, r.accuracy.forward_error);
  }
  check_backward_error(accuracy_.backward_error, solve_.tolerance);
  report_.backward_error = std::max(report_.backward_error, accuracy_.backward_error);
  report_.forward_error = std::max(report_.forward_error, accuracy_.forward_error);
  motions_[1] = std::move(refined[0].motion);
  motions_[0] = preloaded_ ? std::move(refined[1].motion)
                           : BodyVectors<Extended>(motions_[1].size(), Vector6T<Extended>::Zero());
}

void DamagedModel::say(const std::string& phase) const {
  if (solve_.progress) solve_.progress(phase);
}

void DamagedModel::solve() {
  say("factorisation");
  refresh();
  say("refinement");
  refine({});
  recover_parts();
}

}  // namespace bondstatic
