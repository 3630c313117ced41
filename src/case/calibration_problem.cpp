#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bondstatic/case_file.hpp"
#include "case/calibration_targets.hpp"
#include "case/named_parameter.hpp"
#include "formats/write/toml.hpp"

namespace bondstatic {
namespace {

/// Parameters that another case lacks, and bonds that do not follow one, may be meant: they are told.
void add_test(CalibrationProblem& problem, const std::string& name, const std::string& file, Case read) {
  CalibrationTest test{name, std::move(read.model), read.solve, std::move(read.outputs), {}};
  std::vector<std::string> missing, own;
  for (const CalibrationParameter& parameter : problem.parameters) {
    NamedParameter named = find_parameter(test.model, parameter.name);
    if (named.places.empty())
      missing.push_back(fmt::format("{} does not follow {}: {}", test.name, parameter.name, named.message));
    else
      for (const std::string& bonds : own_values(test.model, parameter.name))
        own.push_back(fmt::format("{}: {}, and do not follow {}", file, bonds, parameter.name));
    test.parameters.push_back(std::move(named.places));
  }
  if (missing.size() == problem.parameters.size())
    throw InputError({{{file, 1, 1},
                       fmt::format("none of the parameters is in this test: {}", missing.front()),
                       "take it out of cases, or calibrate what it has"}});
  missing.insert(missing.end(), own.begin(), own.end());
  missing.insert(missing.end(), read.warnings.begin(), read.warnings.end());
  // A case that is read once for each seed says the same each time.
  for (const std::string& warning : missing)
    if (std::find(problem.warnings.begin(), problem.warnings.end(), warning) == problem.warnings.end())
      problem.warnings.push_back(warning);
  problem.tests.push_back(std::move(test));
}

/// A target of each test that it is of.
void spread_target(CalibrationProblem& problem, const CalibrationTarget& target,
                   const std::vector<std::string>& case_of_test) {
  for (std::size_t t = 0; t < problem.tests.size(); ++t) {
    const CalibrationTest& test = problem.tests[t];
    const bool named = target.test.empty() || target.test == case_of_test[t];
    for (const Output& output : test.outputs)
      if (named && output.name == target.output) {
        problem.targets.push_back(target);
        problem.targets.back().test = test.name;
      }
  }
}

}  // namespace

CalibrationProblem read_calibration(const std::string& file, const std::vector<std::string>& overrides,
                                    int threads) {
  CalibrationProblem problem;
  problem.given = read_case(file, overrides, "", Purpose::statics, threads);
  if (!problem.given.calibration)
    throw InputError({{{file, 1, 1},
                       "the case has no [calibration]",
                       "add [calibration] with [[calibration.parameters]] and [[calibration.targets]]"}});
  const CalibrationPlan& plan = *problem.given.calibration;
  problem.parameters = plan.parameters;
  problem.options = plan.options;

  const std::string own = test_name(file, file);
  std::vector<std::string> case_of_test;
  for (const Index seed : plan.seeds) {
    std::vector<std::string> settings = overrides;
    settings.push_back(fmt::format("{}={}", plan.seed_key, seed));
    add_test(problem, fmt::format("{}, {}", own, settings.back()), file,
             read_case(file, settings, "", Purpose::statics, threads));
    case_of_test.push_back(own);
  }
  if (plan.seeds.empty()) {
    Case first;
    first.model = std::move(problem.given.model);
    first.solve = problem.given.solve;
    first.outputs = std::move(problem.given.outputs);
    first.warnings = problem.given.warnings;
    add_test(problem, own, file, std::move(first));
    case_of_test.push_back(own);
  }
  problem.given.model = {};
  problem.given.outputs.clear();
  for (const std::string& other : plan.cases) {
    case_of_test.push_back(test_name(file, other));
    add_test(problem, case_of_test.back(), other, read_case(other, {}, "", Purpose::statics, threads));
  }
  for (const CalibrationTarget& target : plan.targets) spread_target(problem, target, case_of_test);
  for (const CalibrationTest& test : problem.tests)
    if (std::none_of(problem.targets.begin(), problem.targets.end(),
                     [&](const CalibrationTarget& target) { return target.test == test.name; }))
      problem.warnings.push_back(fmt::format("{} has no target, and is not solved", test.name));
  return problem;
}

std::string calibrated_case(const CalibrationProblem& problem, const std::vector<std::string>& overrides,
                            const std::string& folder, const std::vector<double>& values) {
  const CalibrationTest& test = problem.tests.front();
  std::vector<std::string> settings = overrides;
  for (std::size_t p = 0; p < values.size(); ++p)
    for (const BlockParameter& place : test.parameters[p])
      settings.push_back(key_of(test.model, place) + "=" + toml_number(values[p]));
  return read_case(problem.given.file, settings, folder).resolved;
}

}  // namespace bondstatic
