// What `calibrate` tells a reader, and a program.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/case_file.hpp"

namespace bondstatic {

/// How an output differs between the tests (seeds, cases) that have it as a target.
struct OutputScatter {
  std::string output;
  Index tests = 0;
  double mean = 0;
  double deviation = 0;  ///< standard, over tests - 1
};
/// Of outputs that several tests have.
std::vector<OutputScatter> scatter_of(const CalibrationResult& result);

/// Seconds of the first evaluation, which analyses the pattern of the matrix, and the mean of the later ones.
struct EvaluationTimes {
  double first = 0;
  double later = not_given;  ///< NaN: there was but one
};
EvaluationTimes times_of(const CalibrationResult& result);

/// `result` is of `problem`. `written`: where the files went, "" if nowhere.
std::string calibration_report(const CalibrationProblem& problem, const CalibrationResult& result,
                               const std::string& written);
std::string calibration_json(const CalibrationProblem& problem, const CalibrationResult& result,
                             const std::vector<std::string>& files);

/// A row an evaluation: its number from 1, cost, seconds, whether it was a step down, parameters by name.
std::string calibration_history(const CalibrationResult& result);

}  // namespace bondstatic
