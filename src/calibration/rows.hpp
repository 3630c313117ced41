// Targets, test by test: what each residual is.
#pragma once

#include <vector>

#include "bondstatic/calibration.hpp"

namespace bondstatic {

/// residual = (value of the output - wanted) / size
struct TargetRow {
  std::size_t target = 0, test = 0, output = 0;
  double size = 1;  ///< the tolerance; without, what it is to be over
};

/// A target without a test counts in each that has its output. Names that are not there give no row.
std::vector<TargetRow> target_rows(const std::vector<CalibrationTest>& tests,
                                   const std::vector<CalibrationTarget>& targets);

/// The start with what the first test that has the parameter says where none is given. NaN where nothing is.
std::vector<CalibrationParameter> with_starts(const std::vector<CalibrationTest>& tests,
                                              std::vector<CalibrationParameter> parameters);

}  // namespace bondstatic
