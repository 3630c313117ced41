// A million particles: the program from a case file with shuffled tables to the written answer.
#pragma once

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

struct Million {
  Index particles = 1000000;  ///< about
  bool keep = false;          ///< leave case and results where they are
};

void print_million(const Million& asked);

}  // namespace bondstatic::bench
