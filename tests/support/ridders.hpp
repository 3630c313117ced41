// Derivatives by differences, to hold exact ones against: central differences of falling step, extrapolated
// to step zero (C. J. F. Ridders, Adv. Eng. Softw. 4 (1982) 75). Not for what is not smooth within `step`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bondstatic::test {

struct Difference {
  double value = 0;
  double error = 0;  ///< estimated, absolute: what the last extrapolations differ by
};

/// f'(x). `step`: the largest, over which f changes noticeably but is smooth; f is called from x - step to
/// x + step.
template <class F>
Difference ridders(F f, double x, double step) {
  constexpr int rows = 12;
  // All rows: to stop where the estimate grows would fall for two values that agree by chance.
  constexpr double shrink = 1.4, square = shrink * shrink;
  Difference best{0, std::numeric_limits<double>::infinity()};
  std::array<double, rows> before{}, now{};
  for (int row = 0; row < rows; ++row, step /= shrink) {
    // The step that is really taken, as x + step is rounded.
    const double above = x + step, below = x - step;
    now[0] = (f(above) - f(below)) / (above - below);
    double power = square;
    for (std::size_t k = 1; k <= std::size_t(row); ++k, power *= square) {
      now[k] = now[k - 1] + (now[k - 1] - before[k - 1]) / (power - 1);
      const double error = std::max(std::abs(now[k] - now[k - 1]), std::abs(now[k] - before[k - 1]));
      if (error <= best.error) best = {now[k], error};
    }
    before = now;
  }
  return best;
}

}  // namespace bondstatic::test
