#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/plot.hpp"

namespace bondstatic {

namespace {

/// 1, 2 or 5 times a power of ten, at least a sixth of the span.
double round_tick(double span) {
  const double least = span / 6, power = std::pow(10, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least * (1 - 1e-9)) return times * power;
  return 10 * power;
}

/// Of the largest number: a multiple of three.
int exponent_of(double magnitude) {
  return 3 * int(std::floor(std::log10(magnitude * (1 + 1e-9)) / 3));
}

const char* prefix(int exponent) {
  constexpr const char* names[] = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P"};
  return exponent < -15 || exponent > 15 ? nullptr : names[exponent / 3 + 5];
}

}  // namespace

PlotScale plot_scale(const PlotAxis& axis, double least, double largest) {
  PlotScale scale;
  least = std::min(least, 0.0);
  largest = std::max(largest, 0.0);
  if (largest > least) {
    scale.tick = round_tick(largest - least);
    scale.low = std::floor(least / scale.tick + 1e-9) * scale.tick;
    scale.high = std::ceil(largest / scale.tick - 1e-9) * scale.tick;
    const double magnitude = std::max(largest, -least);
    const bool long_numbers = magnitude >= 1e4 || magnitude < 1e-2;
    if (!axis.unit.empty() || long_numbers) scale.exponent = exponent_of(magnitude);
  }
  const char* with = axis.unit.empty() ? nullptr : prefix(scale.exponent);
  if (with)
    scale.label = axis.name + ", " + with + axis.unit;
  else if (scale.exponent != 0)
    scale.label =
        fmt::format("{}, 1e{}{}{}", axis.name, scale.exponent, axis.unit.empty() ? "" : " ", axis.unit);
  else
    scale.label = axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit;
  return scale;
}

}  // namespace bondstatic
