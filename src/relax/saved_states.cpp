#include "relax/saved_states.hpp"

#include <algorithm>
#include <cmath>

#include "io/archive.hpp"

namespace bondstatic {

namespace {

/// The multiple of the interval that a look stands for; times are steps times a step, but for rounding.
double multiple(double time, double interval) {
  return std::floor(time / interval * (1 + 1e-12));
}

}  // namespace

static void describe(Archive& archive, SavedState& state) {
  archive(state.step, state.time);
}

SavedStates::SavedStates(double interval, double between_looks)
    : interval_(std::isnan(interval) ? interval : std::max(interval, between_looks)) {}

bool SavedStates::wants(double time) const {
  if (!any_asked()) return false;
  return states_.empty() || multiple(time, interval_) > multiple(states_.back().time, interval_);
}

void SavedStates::add(const SavedState& state) {
  states_.push_back(state);
  if (states_.size() <= most_saved_states) return;
  // The first look after a multiple of two intervals is the first one after that multiple of one, too.
  interval_ *= 2;
  const auto same_multiple = [&](const SavedState& a, const SavedState& b) {
    return multiple(a.time, interval_) == multiple(b.time, interval_);
  };
  states_.erase(std::unique(states_.begin(), states_.end(), same_multiple), states_.end());
}

std::vector<SavedState> SavedStates::all() const {
  std::vector<SavedState> states = states_;
  if (end_) states.push_back(*end_);
  return states;
}

void SavedStates::carry(Archive& archive) {
  archive(interval_, states_, end_);
}

}  // namespace bondstatic
