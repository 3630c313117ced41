// One solver on one packing: time by phase, peak memory, and the machine's own rates beside it.
#pragma once

#include <string>

#include "bench/packings.hpp"

namespace bondstatic::bench {

enum class Ending { done, failed, does_not_fit, too_long };

struct Measurement {
  Ending ending = Ending::failed;
  char note[256] = "";  ///< first line of what a failure said
  Index particles = 0, bonds = 0, unknowns = 0;
  bool iterative = false;
  double seconds = 0;  ///< of the whole solve, fastest of a few where it is short
  double before = 0, analysis = 0, factorisation = 0, refinement = 0, recovery = 0;
  Index iterations = 0;
  double flops = 0;
  double predicted_bytes = 0, peak_bytes = 0;  ///< above what stood when the analysis began
  double dgemm = 0, triad = 0;                 ///< operations and bytes a second, before or after, the better
};

/// Solvers that are no backends: "naive" (naive.hpp) and "relaxation" (the explicit run to rest).
Measurement measure(const Family& family, Index particles, const std::string& solver, int threads,
                    double longest);

}  // namespace bondstatic::bench
