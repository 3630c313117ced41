#include "calibration/certainty.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "calibration/identifiability.hpp"
#include "calibration/intervals.hpp"
#include "calibration/scaling.hpp"

namespace bondstatic {

using Eigen::Index;

namespace {

LookedAt looked_at(const Eigen::MatrixXd& jacobian, const std::vector<CalibrationParameter>& parameters,
                   const std::vector<double>& values) {
  Eigen::VectorXd logarithmic(Index(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    logarithmic[Index(p)] = logarithmic_slope(parameters[p], values[p]);
  return {jacobian, logarithmic};
}

// Parameters that no bound holds, by what unseen directions do to them.
struct Sorted {
  std::vector<Index> settled;  ///< nothing
  std::vector<Index> loose;    ///< they mix them with others
  Index unseen = 0;            ///< how many of these directions there are
};

Sorted sorted(const std::vector<UnseenDirection>& directions, const std::vector<Index>& free) {
  Sorted found;
  for (const UnseenDirection& d : directions) found.unseen += !d.no_influence;
  for (const Index p : free) {
    bool settled = true, loose = false;
    for (const UnseenDirection& d : directions)
      if (d.direction[p] != 0) settled = false, loose = loose || !d.no_influence;
    if (settled) found.settled.push_back(p);
    if (loose) found.loose.push_back(p);
  }
  return found;
}

// Far beyond what errors of that size give: sums of squares of n normal ones are n +- sqrt(2 n).
bool beyond_tolerances(const Eigen::VectorXd& residuals, Index freedom) {
  return freedom > 0 && residuals.squaredNorm() > double(freedom) + 5 * std::sqrt(2. * double(freedom));
}

}  // namespace

void tell_certainty(CalibrationResult& result, const Eigen::MatrixXd& start_jacobian, const Minimum& minimum,
                    const std::vector<CalibrationParameter>& parameters, Loss loss, bool with_tolerances) {
  std::vector<Index> free;
  std::vector<double> start, values;
  std::vector<std::string> names;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (!minimum.held[p]) free.push_back(Index(p));
    start.push_back(parameters[p].start);
    values.push_back(result.parameters[p].value);
    names.push_back(parameters[p].name);
  }
  const LookedAt at_start = looked_at(start_jacobian, parameters, start);
  const LookedAt at_end = looked_at(minimum.jacobian, parameters, values);
  const std::vector<UnseenDirection> directions = unseen_directions(minimum.jacobian, free);
  for (const UnseenDirection& d : directions)
    result.unidentified.push_back(
        {std::vector<double>(d.direction.begin(), d.direction.end()), sentence(d, names, at_start, at_end)});

  const Sorted which = sorted(directions, free);
  const Intervals found = intervals(minimum, loss, which.settled, which.loose, which.unseen, with_tolerances);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const double x = scaled(parameters[p], values[p]), half = found.half_width[Index(p)];
    result.parameters[p].lower_95 = beyond_bounds(parameters[p], x - half);
    result.parameters[p].upper_95 = beyond_bounds(parameters[p], x + half);
  }
  result.correlation = found.correlation;
  result.singular_values = minimum.jacobian.jacobiSvd().singularValues();
  const Index fitted = Index(which.settled.size() + which.loose.size()) - which.unseen;
  if (with_tolerances && loss == Loss::squares && !which.settled.empty() &&
      beyond_tolerances(minimum.residuals, minimum.residuals.size() - fitted))
    result.warnings.push_back(
        "targets are missed by far more than their tolerances, which the 95 % intervals rest on: these are "
        "too narrow");
  if (!with_tolerances && fitted > 0 && minimum.residuals.size() <= fitted)
    result.warnings.push_back(
        "there are no more targets than parameters and no tolerances, so nothing tells how certain the "
        "parameters are: give tolerances");
}

}  // namespace bondstatic
