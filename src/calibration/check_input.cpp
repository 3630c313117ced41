#include "calibration/check_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bondstatic/error.hpp"
#include "calibration/check_parameters.hpp"
#include "calibration/rows.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? fmt::format("there are: {}", name_list(known))
                         : fmt::format("did you mean {}?", nearest);
}

std::vector<std::string> test_names(const std::vector<CalibrationTest>& tests) {
  std::vector<std::string> names;
  for (const CalibrationTest& test : tests) names.push_back(test.name);
  return names;
}

std::vector<std::string> output_names(const std::vector<CalibrationTest>& tests, const std::string& of) {
  std::vector<std::string> names;
  for (const CalibrationTest& test : tests)
    if (of.empty() || of == test.name)
      for (const Output& output : test.outputs) names.push_back(output.name);
  return names;
}

void check_tests(const std::vector<CalibrationTest>& tests, std::vector<Fault>& faults) {
  if (tests.empty()) faults.push_back({{}, "there is no test", "give a model with outputs"});
  std::set<std::string> names;
  for (const CalibrationTest& test : tests)
    if (!names.insert(test.name).second)
      faults.push_back({{}, fmt::format("two tests are called \"{}\"", test.name), "give each its own name"});
}

void check_names(const std::vector<CalibrationTest>& tests, const CalibrationTarget& target,
                 std::vector<Fault>& faults) {
  const std::vector<std::string> known_tests = test_names(tests);
  if (!target.test.empty() &&
      std::find(known_tests.begin(), known_tests.end(), target.test) == known_tests.end()) {
    faults.push_back({{},
                      fmt::format("target {}: there is no test \"{}\"", target.output, target.test),
                      did_you_mean(target.test, known_tests)});
    return;
  }
  const std::vector<std::string> known = output_names(tests, target.test);
  if (std::find(known.begin(), known.end(), target.output) == known.end())
    faults.push_back({{},
                      fmt::format("target {}: {} has no output of that name", target.output,
                                  target.test.empty() ? "no test" : target.test),
                      known.empty() ? "add it to [[outputs]]" : did_you_mean(target.output, known)});
}

void check_numbers(const CalibrationTarget& target, std::vector<Fault>& faults) {
  const auto fault = [&](const std::string& what, const std::string& cure) {
    faults.push_back({{}, fmt::format("target {}: {}", target.output, what), cure});
  };
  if (!std::isfinite(target.wanted))
    fault(fmt::format("wanted = {} is no number to be met", target.wanted), "give what was measured");
  if (std::isinf(target.tolerance) || target.tolerance <= 0)
    fault(fmt::format("tolerance = {} must be positive and finite", target.tolerance),
          "give the standard deviation of what was measured, or leave it out everywhere");
  if (!std::isfinite(target.weight) || target.weight <= 0)
    fault(fmt::format("weight = {} must be positive and finite", target.weight),
          "leave out targets that shall not count");
  else if (target.weight != 1 && !std::isnan(target.tolerance))
    fault("it has a tolerance and a weight", "give the tolerance alone: it says how much the target counts");
}

// A residual over a tolerance and one over its own size cannot be added.
void check_tolerances(const std::vector<CalibrationTarget>& targets, Loss loss, std::vector<Fault>& faults) {
  std::vector<std::string> with, without;
  for (const CalibrationTarget& target : targets)
    (std::isnan(target.tolerance) ? without : with).push_back(target.output);
  if (!with.empty() && !without.empty())
    faults.push_back({{},
                      fmt::format("some targets have a tolerance and some have none: {}", name_list(without)),
                      "give every target one, or none"});
  if (loss != Loss::squares && !without.empty())
    faults.push_back({{},
                      "a robust loss tells outliers by their tolerances, and there are none",
                      "give every target a tolerance, or use loss = \"squares\""});
}

// A target without a test is of those, too, that another one names.
void check_once(const std::vector<CalibrationTest>& tests, const std::vector<CalibrationTarget>& targets,
                std::vector<Fault>& faults) {
  std::set<std::pair<std::size_t, std::size_t>> taken;
  std::set<std::size_t> told;
  for (const TargetRow& row : target_rows(tests, targets))
    if (!taken.insert({row.test, row.output}).second && told.insert(row.target).second) {
      const std::string& test = targets[row.target].test;
      faults.push_back({{},
                        fmt::format("target {} is given twice{}", targets[row.target].output,
                                    test.empty() ? "" : " for " + test),
                        "give it once, with the mean of what was measured"});
    }
}

void check_targets(const std::vector<CalibrationTest>& tests, const std::vector<CalibrationTarget>& targets,
                   Loss loss, std::vector<Fault>& faults) {
  if (targets.empty())
    faults.push_back({{}, "there are no targets", "say which outputs shall have which values"});
  for (const CalibrationTarget& target : targets) {
    check_names(tests, target, faults);
    check_numbers(target, faults);
  }
  check_once(tests, targets, faults);
  check_tolerances(targets, loss, faults);
}

void check_options(const CalibrationOptions& options, std::vector<Fault>& faults) {
  if (options.most_evaluations < 1)
    faults.push_back(
        {{}, fmt::format("most_evaluations = {} must be positive", options.most_evaluations), "allow 50"});
  if (!(options.tolerance > 0 && options.tolerance < 1))
    faults.push_back(
        {{}, fmt::format("tolerance = {} must lie between 0 and 1", options.tolerance), "1e-12"});
}

// At most twenty of what may be thousands.
std::vector<Fault> at_most_twenty(std::vector<Fault> faults) {
  constexpr std::size_t most = 20;
  if (faults.size() <= most) return faults;
  const std::size_t more = faults.size() - most;
  faults.resize(most);
  faults.push_back({{}, fmt::format("and {} more", more), ""});
  return faults;
}

}  // namespace

void check_calibration(const std::vector<CalibrationTest>& tests,
                       const std::vector<CalibrationParameter>& parameters,
                       const std::vector<CalibrationTarget>& targets, const CalibrationOptions& options) {
  std::vector<Fault> faults;
  check_tests(tests, faults);
  check_parameters(tests, parameters, faults);
  check_targets(tests, targets, options.loss, faults);
  check_options(options, faults);
  const std::size_t data = target_rows(tests, targets).size();
  if (data > 0 && parameters.size() > data)
    faults.push_back({{},
                      fmt::format("{} parameters cannot be found from {} target{}", parameters.size(), data,
                                  data == 1 ? "" : "s"),
                      "give more targets, or leave parameters out"});
  if (!faults.empty()) throw InputError(at_most_twenty(std::move(faults)));
}

}  // namespace bondstatic
