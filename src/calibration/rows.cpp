#include "calibration/rows.hpp"

#include <cmath>

namespace bondstatic {

namespace {

double size_of(const CalibrationTarget& target) {
  if (!std::isnan(target.tolerance)) return target.tolerance;
  return (target.wanted == 0 ? 1 : std::abs(target.wanted)) / target.weight;
}

}  // namespace

std::vector<TargetRow> target_rows(const std::vector<CalibrationTest>& tests,
                                   const std::vector<CalibrationTarget>& targets) {
  std::vector<TargetRow> rows;
  for (std::size_t t = 0; t < targets.size(); ++t)
    for (std::size_t k = 0; k < tests.size(); ++k) {
      if (!targets[t].test.empty() && targets[t].test != tests[k].name) continue;
      for (std::size_t o = 0; o < tests[k].outputs.size(); ++o)
        if (tests[k].outputs[o].name == targets[t].output) rows.push_back({t, k, o, size_of(targets[t])});
    }
  return rows;
}

std::vector<CalibrationParameter> with_starts(const std::vector<CalibrationTest>& tests,
                                              std::vector<CalibrationParameter> parameters) {
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const CalibrationTest& test : tests) {
      if (!std::isnan(parameters[p].start)) break;
      if (p >= test.parameters.size() || test.parameters[p].empty()) continue;
      const BlockParameter& first = test.parameters[p].front();
      parameters[p].start = test.model.blocks.at(std::size_t(first.block)).parameters.at(first.parameter);
    }
  return parameters;
}

}  // namespace bondstatic
