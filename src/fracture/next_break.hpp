// Which bonds break next, and at what factor.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bondstatic/fracture.hpp"
#include "bondstatic/network.hpp"

namespace bondstatic {

/// What a bond carries under the loads that stay, and per unit of factor under those that scale.
struct CarriedParts {
  SectionVector held;
  SectionVector scaled;
};

struct NextBreak {
  double factor = 0;
  std::vector<BrokenBond> bonds;  ///< ascending; several where they tie
  double runner_up = 0;           ///< largest utilisation of all others at that factor
};

/// The bonds that reach their strength first as the factor grows from `from`; where some are beyond it there
/// already, those that are most. Nothing where none ever does. Bonds that carry nothing never break. Does not
/// depend on `threads`.
std::optional<NextBreak> next_break(const BondFailures& failures, const BondNetwork& network,
                                    std::span<const CarriedParts> carried, double from, double tie,
                                    int threads);

}  // namespace bondstatic
