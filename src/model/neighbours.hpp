// Which spheres touch: linear in their number whatever the spread of their sizes.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// All pairs i < j with |x_i - x_j| <= reach_i + reach_j, sorted by (i, j). Reaches are not negative.
/// Nothing but the time depends on `threads`.
std::vector<std::pair<Index, Index>> touching_pairs(std::span<const Vector3> positions,
                                                    std::span<const double> reach, int threads = 1);

}  // namespace bondstatic
