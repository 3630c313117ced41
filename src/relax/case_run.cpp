#include "relax/case_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bondstatic/error.hpp"
#include "io/archive.hpp"

namespace bondstatic {

namespace {

/// How many times a stretch of calm is looked at: a turning point is not taken for rest.
constexpr double looks_a_hold = 16;

/// Energy beyond all work that was done; a stable step holds back at most a few times of it.
constexpr double blown_up = 1e4;

Index steps_in(double time, double time_step) {
  return std::max<Index>(1, Index(std::ceil(time / time_step * (1 - 1e-12))));
}

Index stretch_between_looks(const DynamicPlan& plan, const RelaxOptions& options) {
  const double wanted = std::isnan(options.record_interval)
                            ? plan.hold_time / looks_a_hold
                            : std::min(options.record_interval, plan.hold_time / 4);
  return std::max<Index>(1, Index(wanted / plan.time_step));
}

DynamicOptions dynamic_options(const DynamicPlan& plan, const RelaxOptions& options, int threads) {
  return {options.kinematics, options.particle_damping, options.bond_damping, plan.time_step,
          options.ramp,       plan.ramp_time,           options.load_factor,  threads};
}

}  // namespace

CaseRun::CaseRun(const Model& model, std::span<const BondProperties> properties, Index load_case,
                 const std::vector<bool>& left_out, const DynamicPlan& plan, const RelaxOptions& options,
                 int threads)
    : plan_(plan),
      options_(options),
      run_(model, properties, load_case, left_out, dynamic_options(plan, options, threads)),
      stretch_(stretch_between_looks(plan, options)),
      hold_steps_(steps_in(plan.hold_time, plan.time_step)),
      saved_(options.save_interval, double(stretch_) * plan.time_step) {}

bool CaseRun::go_on(const RelaxHooks& hooks) {
  if (ended_) return false;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  if (run_.step() == 0) look(hooks);
  // Looks stand at whole stretches, whatever limit of steps has ended an earlier part.
  const Index steps = std::min(stretch_ - run_.step() % stretch_, options_.max_steps - run_.step());
  run_.advance(steps);
  look(hooks);
  const double took = std::chrono::duration<double>(Clock::now() - begin).count();
  seconds_ += took;
  seconds_a_step_ = steps > 0 ? took / double(steps) : 0;
  return !ended_;
}

void CaseRun::look(const RelaxHooks& hooks) {
  const Energies energies = run_.energies();
  check_for_blow_up(energies);
  unrest_ = run_.unrest();

  const bool calm = run_.time() >= plan_.ramp_time && unrest_.fastest < options_.velocity_limit &&
                    unrest_.unbalanced < options_.force_limit;
  // A look at the limit of steps leaves no trace for a run that goes on with a higher one.
  if (!calm && on_grid()) calm_since_ = -1;
  if (calm && on_grid() && calm_since_ < 0) calm_since_ = run_.step();
  at_rest_ = calm && on_grid() && run_.step() - calm_since_ >= hold_steps_;
  ended_ = at_rest_ || run_.step() >= options_.max_steps;
  record(hooks, energies);
  save(hooks);
}

void CaseRun::record(const RelaxHooks& hooks, const Energies& energies) {
  const bool wanted = on_grid() && history_.wants(run_.step() / stretch_);
  if (!ended_ && !wanted) return;
  Probes row{{"step", double(run_.step())},       {"time", run_.time()},
             {"load_factor", run_.load_factor()}, {"kinetic", energies.kinetic},
             {"strain", energies.strain},         {"work", energies.work},
             {"dissipated", energies.dissipated}, {"balance", energies.balance()},
             {"fastest", unrest_.fastest},        {"unbalanced", unrest_.unbalanced}};
  if (hooks.probe)
    for (auto& more : hooks.probe(run_.state())) row.push_back(std::move(more));
  if (wanted) return history_.add(row);
  for (const auto& [name, value] : row) last_row_.push_back(value);
}

void CaseRun::save(const RelaxHooks& hooks) {
  if (!hooks.show || !saved_.any_asked()) return;
  const SavedState here{run_.step(), run_.time()};
  const bool wanted = on_grid() && saved_.wants(here.time);
  if (!wanted && !ended_) return;
  wanted ? saved_.add(here) : saved_.end_at(here);
  const State state = run_.state();
  std::vector<Vector6> velocity(state.displacement.size(), Vector6::Constant(not_given));
  for (std::size_t p = 0; p < velocity.size(); ++p)
    if (!std::isnan(state.displacement[p][0])) velocity[p] = run_.velocity(Index(p));
  hooks.show(state, velocity, saved_.all());
}

void CaseRun::check_for_blow_up(const Energies& energies) {
  most_work_ = std::max(most_work_, std::max(std::abs(energies.work), std::abs(energies.initial)));
  const double energy = energies.kinetic + energies.strain;
  // One step into a ramp the load has made speed, by half a kick, and gone no way.
  if (run_.step() < 2 || energy <= blown_up * most_work_) return;
  const double ratio = plan_.time_step / plan_.critical_time_step;
  throw AccuracyError(fmt::format(
      "the run blew up by step {} (time {:.4g}): its energy {:.3g} is no longer that of the work done, "
      "{:.3g}\n"
      "    the time step {:.6g} is {:.4g} times the critical one, {:.6g}\n"
      "    cure: {}",
      run_.step(), run_.time(), energy, most_work_, plan_.time_step, ratio, plan_.critical_time_step,
      ratio > 0.95
          ? "leave time_step out of [dynamics], or give safety = 0.8"
          : "the motion is too large for these bonds: apply less load, or apply it more slowly (ramp_time)"));
}

double CaseRun::seconds_left() const {
  if (!(plan_.decay > 0) || plan_.lowest.empty()) return not_given;
  const double unrest =
      std::max(unrest_.fastest / options_.velocity_limit, unrest_.unbalanced / options_.force_limit);
  const double ramping = std::max(0.0, plan_.ramp_time - run_.time());
  const double dying = unrest > 1 ? std::log(unrest) / plan_.decay : 0;
  const double holding = calm_since_ < 0
                             ? plan_.hold_time
                             : plan_.hold_time - double(run_.step() - calm_since_) * plan_.time_step;
  return (ramping + dying + std::max(0.0, holding)) / plan_.time_step * seconds_a_step_;
}

RelaxedCase CaseRun::result() const {
  RelaxedCase result;
  result.state = run_.state();
  result.plan = plan_;
  result.end = at_rest_ ? RunEnd::at_rest : ended_ ? RunEnd::step_limit : RunEnd::interrupted;
  result.steps = run_.step();
  result.time = run_.time();
  result.energies = run_.energies();
  result.unrest = unrest_;
  result.seconds = seconds_;
  result.history = history_.columns();
  for (std::size_t c = 0; c < last_row_.size(); ++c) result.history[c].values.push_back(last_row_[c]);
  result.saved = saved_.all();
  return result;
}

void CaseRun::carry(Archive& archive) {
  std::string run = archive.reading() ? "" : run_.save();
  archive(run, calm_since_, ended_, at_rest_, most_work_, seconds_);
  archive(unrest_.fastest, unrest_.particle, unrest_.unbalanced);
  history_.carry(archive);
  archive(last_row_);
  saved_.carry(archive);
  if (!archive.reading()) return;
  run_.load(run);
  if (!at_rest_) ended_ = run_.step() >= options_.max_steps;  // the limit may have been raised
  if (ended_) return;
  last_row_.clear();
  saved_.forget_end();
}

}  // namespace bondstatic
