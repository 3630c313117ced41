// Parameters as the least squares see them: logarithms, or parts of the range between the bounds, both
// counted from the start, so that the start itself and what is near it come back to the last digit.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bondstatic/calibration.hpp"

namespace bondstatic {

double scaled(const CalibrationParameter& parameter, double value);

/// Back; a bound comes back as itself, and nothing from beyond it.
double unscaled(const CalibrationParameter& parameter, double x);

/// Back, bounds or not: ends of intervals.
double beyond_bounds(const CalibrationParameter& parameter, double x);

/// d(value)/dx.
double slope(const CalibrationParameter& parameter, double value);

/// d(ln value)/dx; NaN where there is no logarithm.
double logarithmic_slope(const CalibrationParameter& parameter, double value);

std::vector<double> unscaled(const std::vector<CalibrationParameter>& parameters, const Eigen::VectorXd& x);

}  // namespace bondstatic
