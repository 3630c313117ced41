// Which states of a run are kept on its way: one for each multiple of an interval, and never too many.
#pragma once

#include <optional>

#include "bondstatic/relaxation.hpp"

namespace bondstatic {

class Archive;

class SavedStates {
 public:
  /// NaN: none are kept. Looks that stand farther apart than the interval are kept one and all.
  SavedStates(double interval, double between_looks);

  bool any_asked() const { return interval_ > 0; }

  /// Whether this look is the first one at or after a multiple of the interval. Its turn comes once.
  bool wants(double time) const;
  /// Where they become too many the interval doubles, and what it no longer asks for is dropped.
  void add(const SavedState& state);

  /// Where the run ended, unless that is among them. A run that goes on forgets it.
  void end_at(const SavedState& state) { end_ = state; }
  void forget_end() { end_.reset(); }

  std::vector<SavedState> all() const;
  double interval() const { return interval_; }
  void carry(Archive& archive);

 private:
  double interval_;
  std::vector<SavedState> states_;
  std::optional<SavedState> end_;
};

}  // namespace bondstatic
