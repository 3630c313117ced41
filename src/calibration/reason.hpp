#pragma once

#include <string>

#include "bondstatic/calibration.hpp"
#include "calibration/least_squares.hpp"

namespace bondstatic {

/// Within its tolerance; without one, within 1e-6 of what is wanted.
bool met(const AchievedTarget& target, bool with_tolerances);

/// Why it ended, as a sentence: what was met, or which targets were missed by how much and which bounds are
/// in the way. `result` has its parameters, targets and `reached`; `failure` is what the last failed solve
/// said, "" where none did.
std::string reason(const CalibrationResult& result, Ending ending,
                   const std::vector<CalibrationParameter>& parameters, bool with_tolerances,
                   const std::string& failure);

}  // namespace bondstatic
