#pragma once

#include <vector>

#include "bondstatic/calibration.hpp"

namespace bondstatic {

/// Throws InputError with everything that is wrong with what is asked. `parameters` have their starts.
void check_calibration(const std::vector<CalibrationTest>& tests,
                       const std::vector<CalibrationParameter>& parameters,
                       const std::vector<CalibrationTarget>& targets, const CalibrationOptions& options);

}  // namespace bondstatic
