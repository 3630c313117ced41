// `bondstatic solve` by several ranks: rank 0 reads the case and deals it out, and from then on no rank has
// more of it than its piece.
#pragma once

#include "app/commands.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

ExitCode solve_on_ranks(const SolveArguments& arguments, Ranks& ranks);

}  // namespace bondstatic
