// How near to breaking each bond is.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

/// Of the worst mode of each bond; NaN where it is broken, left out, or has no strength. `break_event` as in
/// Fracture.
std::vector<double> bond_utilisations(const Model& model, const State& state,
                                      const std::vector<Index>& break_event);

}  // namespace bondstatic
