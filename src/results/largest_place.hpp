// Which particle of a state moves most.
#pragma once

#include "bondstatic/state.hpp"

namespace bondstatic {

struct LargestPlace {
  Index particle = -1;  ///< its position; -1 where all are left out
  double magnitude = -1;
};

/// Of the particles 0 ... count-1; the first of several that move alike.
LargestPlace largest_place(const State& state, Index count);

}  // namespace bondstatic
