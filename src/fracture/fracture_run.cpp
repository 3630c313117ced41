#include "fracture/fracture_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

// A specimen that takes this part of its first energy for the same pattern is in two.
constexpr double in_two = 1e-12;

}  // namespace

FractureRun::FractureRun(const Model& model, const FractureOptions& options, const StaticOptions& solve,
                         const FractureHooks& hooks, int threads)
    : model_(model),
      options_(options),
      hooks_(hooks),
      threads_(threads),
      damaged_(model, options, solve, threads, result_.report),
      failures_(bond_failures(model, damaged_.properties())) {
  result_.break_event.assign(model.bonds.size(), -1);
  result_.report.first.threads = threads;
  fingerprint_ = fingerprint();
  if (failures_.modes.empty())
    throw Error(
        ExitCode::invalid_input,
        "no bond has a strength, so none can break\n    cure: add strength = { criterion = ... } to a "
        "[[bonds]] block");
}

void FractureRun::measure() {
  load_ = damaged_.load();
  displacement_ = damaged_.displacement();
  held_work_ = damaged_.held_work();
}

FractureRun::Point FractureRun::point(double factor) const {
  return {load_.at(factor), displacement_.at(factor) - rest_displacement_, held_work_.at(factor)};
}

// Along a straight line of loads and displacements.
void FractureRun::move_to(const Point& to) {
  work_ += 0.5 * (at_.load + to.load) * (to.displacement - at_.displacement) + to.held_work - at_.held_work;
  at_ = to;
}

void FractureRun::end(FractureEnd how, std::string reason) {
  ended_ = true;
  result_.end = how;
  result_.reason = std::move(reason);
}

bool FractureRun::passes_a_limit(const NextBreak& next) {
  const Point there = point(next.factor);
  if (next.factor > options_.max_factor) {
    factor_ = options_.max_factor;
    end(FractureEnd::factor, fmt::format("the next bond breaks at the factor {:.6g}", next.factor));
  } else if (there.displacement > options_.max_displacement) {
    factor_ = (options_.max_displacement + rest_displacement_ - displacement_.held) / displacement_.scaled;
    end(FractureEnd::displacement,
        fmt::format("the next bond breaks at the displacement {:.6g}", there.displacement));
  } else if (options_.load_drop < 1 && largest_load_ > 0 &&
             there.load <= (1 - options_.load_drop) * largest_load_) {
    end(FractureEnd::load_drop,
        fmt::format("the load is down at {:.6g}, the largest was {:.6g}", there.load, largest_load_));
  }
  return ended_;
}

void FractureRun::start_event(const NextBreak& next) {
  FractureEvent event;
  // What is controlled has not moved since the last break: the avalanche goes on.
  const double reached = options_.control == FractureControl::event ? largest_factor_ : factor_;
  const bool goes_on = !result_.events.empty() && next.factor <= (1 + options_.tie) * reached;
  event.avalanche = (result_.events.empty() ? 0 : result_.events.back().avalanche) + (goes_on ? 0 : 1);
  factor_ = next.factor;
  largest_factor_ = std::max(largest_factor_, factor_);
  move_to(point(factor_));
  largest_load_ = std::max(largest_load_, at_.load);
  event.factor = factor_;
  event.load = at_.load;
  event.displacement = at_.displacement;
  event.runner_up = next.runner_up;
  event.bonds = next.bonds;
  for (const BrokenBond& broken : next.bonds)
    result_.break_event[std::size_t(broken.bond)] = Index(result_.events.size());
  breaks_ += Index(next.bonds.size());
  result_.events.push_back(std::move(event));
}

double FractureRun::factor_at_control(const Point& held) const {
  switch (options_.control) {
    case FractureControl::load:
      return (held.load - load_.held) / load_.scaled;
    case FractureControl::displacement:
      return (held.displacement + rest_displacement_ - displacement_.held) / displacement_.scaled;
    case FractureControl::event:
      break;
  }
  return factor_;
}

void FractureRun::separate(const DamagedModel::Removal& removal) {
  for (const auto& body : removal.separated) {
    SeparatedBody& separated = result_.separated.emplace_back();
    separated.event = result_.events.size() - 1;
    for (const Index p : body) separated.particles.push_back(model_.particles[std::size_t(p)].id);
  }
}

void FractureRun::break_bonds() {
  FractureEvent& event = result_.events.back();
  std::vector<Vector6> carried;
  for (const BrokenBond& broken : event.bonds)
    carried.push_back(damaged_.resultants_of(broken.bond, factor_));
  const double energy_before = damaged_.energy().at(factor_), work_before = work_;
  const DamagedModel::Removal removal = damaged_.take_out(event.bonds);
  separate(removal);
  if (removal.outcome != DamagedModel::Outcome::stands) {
    event.factor_after = event.load_after = event.displacement_after = not_given;
    event.released = event.strain_energy = event.work = event.dissipated = not_given;
    const bool cut_off = removal.outcome == DamagedModel::Outcome::cut_off;
    return end(cut_off ? FractureEnd::separated : FractureEnd::mechanism, removal.what);
  }
  measure();
  if (damaged_.energy().scaled <= in_two * whole_stiffness_) {
    load_.scaled = 0;  // but for rounding
    end(FractureEnd::separated, "nothing that is left carries the pattern");
  } else {
    factor_ = factor_at_control(at_);
  }
  const double energy = damaged_.energy().at(factor_);
  // Loads that fall off do their work elsewhere.
  at_.held_work -= removal.lost_work.at(event.factor);
  move_to(point(factor_));
  if (removal.load_lost)
    event.released = energy_before - energy + work_ - work_before;
  else
    for (std::size_t i = 0; i < carried.size(); ++i)
      event.released += 0.5 * carried[i].dot(damaged_.motion_of(event.bonds[i].bond, factor_));
  dissipated_ += event.released;
  event.factor_after = factor_;
  event.load_after = at_.load;
  event.displacement_after = at_.displacement;
  event.strain_energy = energy;
  event.work = work_;
  event.dissipated = dissipated_;
  const double stored = energy - rest_energy_, scale = std::abs(work_) + std::abs(stored) + dissipated_;
  if (scale > 0)
    result_.report.energy_balance =
        std::max(result_.report.energy_balance, std::abs(work_ - stored - dissipated_) / scale);
}

bool FractureRun::step() {
  const double from = options_.control == FractureControl::event ? 0 : factor_;
  const auto next =
      next_break(failures_, damaged_.network(), damaged_.carried(), from, options_.tie, threads_);
  if (!next) {
    end(FractureEnd::unbreakable, "no bond reaches its strength however large the factor");
    return false;
  }
  if (passes_a_limit(*next)) return false;
  start_event(*next);
  if (result_.events.size() == 1) show(0);
  if (hooks_.probe) hooks_.probe(result_.events.size() - 1, state());
  break_bonds();
  if (ended_) return false;
  if (breaks_ >= options_.max_breaks) {
    end(FractureEnd::breaks, fmt::format("{} bonds are broken", breaks_));
    return false;
  }
  if (options_.save_every > 0 && breaks_ / options_.save_every > shown_) {
    shown_ = breaks_ / options_.save_every;
    show(result_.events.size());
  }
  return true;
}

State FractureRun::state() const {
  State now = damaged_.state(factor_);
  now.name = model_.load_cases.at(std::size_t(options_.pattern));
  return now;
}

void FractureRun::show(std::size_t events) {
  if (!hooks_.show) return;
  if (events == 0) {
    // While all is whole.
    const std::vector<Index> unbroken(result_.break_event.size(), -1);
    return hooks_.show(0, state(), unbroken);
  }
  hooks_.show(events, state(), result_.break_event);
}

bool FractureRun::wants_to_go_on() {
  if (!hooks_.progress) return true;
  return hooks_.progress(
      {Index(result_.events.size()), breaks_, factor_, at_.load, at_.displacement, largest_load_});
}

Fracture FractureRun::run() {
  const auto begun = std::chrono::steady_clock::now();
  kept_ = begun;
  if (hooks_.resume.empty()) {
    damaged_.solve();
    measure();
    whole_stiffness_ = damaged_.energy().scaled;
    rest_energy_ = damaged_.energy().at(0);
    rest_displacement_ = displacement_.held;
    at_ = point(0);
  } else {
    resume();
  }
  take_snapshot();
  while (step()) {
    if (damaged_.worth_refreshing()) {
      damaged_.refresh();
      take_snapshot();
    }
    if (!wants_to_go_on()) {
      if (hooks_.keep) hooks_.keep(snapshot_);
      end(FractureEnd::interrupted, "stopped");
      break;
    }
  }
  const std::size_t events = result_.events.size();
  result_.last = state();
  if (events > 0 && result_.end != FractureEnd::interrupted) show(events);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  result_.report.seconds += taken.count();
  return std::move(result_);
}

}  // namespace bondstatic
