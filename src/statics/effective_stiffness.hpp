#pragma once

#include <optional>
#include <vector>

#include "bondstatic/network.hpp"
#include "bondstatic/statics.hpp"
#include "model/boundary.hpp"

namespace bondstatic {

/// See StaticSolution::effective; `boundaries` one a load case, `left_out` by particle. On several ranks the
/// same on all.
std::optional<EffectiveStiffness> effective_stiffness(const Model& model, const BondNetwork& network,
                                                      const std::vector<Boundary>& boundaries,
                                                      const std::vector<bool>& left_out,
                                                      const StaticSolution& solution);

}  // namespace bondstatic
