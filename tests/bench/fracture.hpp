// What a break costs: against a full refactorisation, and by three ways to go on without one.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

struct BreakCost {
  std::vector<std::string> packings;  ///< only these; empty: disordered FCC and YADE-like
  std::vector<Index> particles;       ///< about; empty: 2,000, 8,000 and 27,000
};

void print_break_cost(const BreakCost& asked);

}  // namespace bondstatic::bench
