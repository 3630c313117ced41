// One linear solve to a true relative residual: |b - K u| / |b|, 2-norm over the unknowns, formed here bond
// by bond in double, whatever a solver says of itself.
#pragma once

#include <string>

#include "bench/packings.hpp"

namespace bondstatic::bench {

struct ToResidual {
  static constexpr int most_rounds = 12;

  bool reached = false;
  char note[256] = "";  ///< first line of what a failure said
  Index particles = 0, bonds = 0, unknowns = 0;
  Index iterations = 0;           ///< of all rounds
  int rounds = 0;                 ///< solves, each of what the one before left
  double left[most_rounds] = {};  ///< true relative residual after each
  double set_up = 0;              ///< analysis and factorisation or set-up; processor seconds, as those below
  double solves = 0, residuals = 0;  ///< the solver's, and forming the residual after each
  double wall = 0;                   ///< seconds of all three on the clock
  double peak_bytes = 0;             ///< above what stood when the analysis began

  double total() const { return set_up + solves + residuals; }
};

/// From the bond network on, on one thread, in a child process that does nothing else.
ToResidual solve_to_residual(const Family& family, Index particles, const std::string& solver, double goal,
                             double longest);

}  // namespace bondstatic::bench
