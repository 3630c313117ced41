#pragma once

#include <vector>

#include "bondstatic/calibration.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {

/// What is wrong with the parameters, each by itself, with what they move in the tests, and with each other.
void check_parameters(const std::vector<CalibrationTest>& tests,
                      const std::vector<CalibrationParameter>& parameters, std::vector<Fault>& faults);

}  // namespace bondstatic
