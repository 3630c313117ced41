#include "calibration/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

double range(const CalibrationParameter& parameter) {
  return parameter.upper - parameter.lower;
}

}  // namespace

double scaled(const CalibrationParameter& parameter, double value) {
  return parameter.logarithmic ? std::log(value / parameter.start)
                               : (value - parameter.start) / range(parameter);
}

double unscaled(const CalibrationParameter& parameter, double x) {
  if (x <= scaled(parameter, parameter.lower)) return parameter.lower;
  if (x >= scaled(parameter, parameter.upper)) return parameter.upper;
  return std::clamp(beyond_bounds(parameter, x), parameter.lower, parameter.upper);
}

double beyond_bounds(const CalibrationParameter& parameter, double x) {
  return parameter.start + (parameter.logarithmic ? parameter.start * std::expm1(x) : x * range(parameter));
}

double slope(const CalibrationParameter& parameter, double value) {
  return parameter.logarithmic ? value : range(parameter);
}

double logarithmic_slope(const CalibrationParameter& parameter, double value) {
  return value > 0 ? slope(parameter, value) / value : not_given;
}

std::vector<double> unscaled(const std::vector<CalibrationParameter>& parameters, const Eigen::VectorXd& x) {
  std::vector<double> values;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    values.push_back(unscaled(parameters[p], x[Eigen::Index(p)]));
  return values;
}

}  // namespace bondstatic
