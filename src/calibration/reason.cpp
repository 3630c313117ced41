#include "calibration/reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibration/wording.hpp"

namespace bondstatic {

namespace {

bool of_several_tests(const std::vector<AchievedTarget>& targets) {
  return std::any_of(targets.begin(), targets.end(),
                     [&](const AchievedTarget& target) { return target.test != targets.front().test; });
}

// The three that are missed most.
std::string missed(const CalibrationResult& result, bool with_tolerances) {
  std::vector<AchievedTarget> targets;
  for (const AchievedTarget& target : result.targets)
    if (!met(target, with_tolerances)) targets.push_back(target);
  std::stable_sort(targets.begin(), targets.end(), [](const AchievedTarget& a, const AchievedTarget& b) {
    return std::abs(a.residual) > std::abs(b.residual);
  });
  const bool several = of_several_tests(result.targets);
  std::string text = fmt::format("{} of {} target{} missed", targets.size(), result.targets.size(),
                                 result.targets.size() == 1 ? " is" : "s are");
  for (std::size_t i = 0; i < std::min<std::size_t>(targets.size(), 3); ++i) {
    const AchievedTarget& target = targets[i];
    const std::string by = with_tolerances ? fmt::format("{:.3g} tolerances", std::abs(target.residual))
                           : target.wanted == 0
                               ? fmt::format("{:.3g}", std::abs(target.achieved))
                               : fmt::format("{:.3g} %", 100 * std::abs(target.achieved / target.wanted - 1));
    text += fmt::format("{} {} is {:.6g} instead of {:.6g}, off by {}", i == 0 ? ":" : ",",
                        several ? target.output + " of " + target.test : target.output, target.achieved,
                        target.wanted, by);
  }
  return text;
}

std::string bounds_in_the_way(const CalibrationResult& result,
                              const std::vector<CalibrationParameter>& parameters) {
  std::vector<std::string> which;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const CalibratedParameter& found = result.parameters[p];
    if (!found.at_bound) continue;
    const bool upper = found.value == parameters[p].upper;
    which.push_back(
        fmt::format("{} is at its {} bound {:.6g}", found.name, upper ? "upper" : "lower", found.value));
  }
  return listed(which);
}

}  // namespace

bool met(const AchievedTarget& target, bool with_tolerances) {
  if (with_tolerances) return std::abs(target.residual) <= 1;
  return std::abs(target.achieved - target.wanted) <=
         1e-6 * (target.wanted == 0 ? 1 : std::abs(target.wanted));
}

std::string reason(const CalibrationResult& result, Ending ending,
                   const std::vector<CalibrationParameter>& parameters, bool with_tolerances,
                   const std::string& failure) {
  std::string text;
  if (result.reached)
    text = with_tolerances ? "every target is met within its tolerance" : "every target is met";
  else
    text = missed(result, with_tolerances);
  if (ending == Ending::too_many_evaluations)
    return fmt::format("stopped after {} evaluations, before a minimum was found; {}", result.history.size(),
                       text);
  if (ending == Ending::stuck)
    return fmt::format("no shorter step lowers the misfit{}; {}",
                       failure.empty() ? "" : fmt::format(", a solve on the way failed ({})", failure), text);
  const std::string bounds = bounds_in_the_way(result, parameters);
  if (result.reached) return bounds.empty() ? text : fmt::format("{}; {}", text, bounds);
  if (bounds.empty()) return fmt::format("this is the least squares minimum; {}", text);
  return fmt::format("{}; what is wanted is out of reach, this is the nearest: {}", bounds, text);
}

}  // namespace bondstatic
