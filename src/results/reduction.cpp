#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/output_values.hpp"

namespace bondstatic {

namespace {

bool counts(double value) {
  return !std::isnan(value);
}

void need_one_value(const Output& output, std::size_t values) {
  if (output.reduce == Output::Reduce::value && values != 1)
    refuse(output, fmt::format("\"{}\" at {} places is not one value", output.of, values),
           "select one, or set reduce to \"sum\", \"mean\" or \"max\"");
}

}  // namespace

double reduce(const Output& output, std::vector<double> values) {
  need_one_value(output, values.size());
  if (output.reduce == Output::Reduce::value) return values.front();
  std::erase_if(values, [](double value) { return !counts(value); });
  if (values.empty()) return not_given;
  if (output.reduce == Output::Reduce::max) return *std::max_element(values.begin(), values.end());
  long double sum = 0;
  for (const double value : values) sum += value;
  if (output.reduce == Output::Reduce::mean) sum /= static_cast<long double>(values.size());
  return double(sum);
}

std::vector<double> reduction_slope(const Output& output, const std::vector<double>& values) {
  need_one_value(output, values.size());
  std::vector<double> slope(values.size(), 0);
  const double counted = double(std::count_if(values.begin(), values.end(), counts));
  auto largest = values.end();
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (!counts(*value)) continue;
    if (largest == values.end() || *value > *largest) largest = value;
    slope[std::size_t(value - values.begin())] = output.reduce == Output::Reduce::mean ? 1 / counted : 1;
  }
  if (output.reduce == Output::Reduce::max && largest != values.end()) {
    std::fill(slope.begin(), slope.end(), 0);
    slope[std::size_t(largest - values.begin())] = 1;
  }
  return slope;
}

}  // namespace bondstatic
