#pragma once

#include "bondstatic/calibration.hpp"
#include "calibration/least_squares.hpp"

namespace bondstatic {

/// Fills in what the tests tell of the parameters, whose values `result` has: directions that no target sees,
/// intervals, correlation, singular values, and a warning where nothing tells how large errors are.
void tell_certainty(CalibrationResult& result, const Eigen::MatrixXd& start_jacobian, const Minimum& minimum,
                    const std::vector<CalibrationParameter>& parameters, Loss loss, bool with_tolerances);

}  // namespace bondstatic
