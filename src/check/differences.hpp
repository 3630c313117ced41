// Fields of two states, compared.
#pragma once

#include "bondstatic/check.hpp"

namespace bondstatic {

/// A run's state at `load_factor` times the loads.
struct ScaledState {
  const State* state;
  double load_factor;
};

/// One entry a field. `runs` begins with that under the full load; further ones tell orders apart. `length`
/// turns rotations into displacements and forces into moments where one of a kind vanishes.
std::vector<FieldDifference> differences(const State& statics, const std::vector<ScaledState>& runs,
                                         double length);

}  // namespace bondstatic
