// The multigrid against PETSc's GAMG, both to the same true residual: a Markdown table.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

struct Race {
  std::vector<std::string> packings;  ///< only these; empty: disordered FCC, as it is and heterogeneous
  Index particles = 125000;           ///< about
};

void race_to_residual(const Race& race);

}  // namespace bondstatic::bench
