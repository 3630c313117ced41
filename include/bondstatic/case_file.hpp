// Reading a case file (TOML) into a model and what is asked of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/calibration.hpp"
#include "bondstatic/fracture.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/relaxation.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// What a case is read for decides what it must have.
enum class Purpose {
  statics,
  dynamics,  ///< a run through time: every particle needs a density
  fracture,  ///< bonds break: some need a strength
};

struct Case {
  std::string title;
  std::string file;  ///< as given
  Model model;
  StaticOptions solve;
  RelaxOptions relax;  ///< of [dynamics] and [check]
  std::vector<Output> outputs;
  std::optional<CalibrationPlan> calibration;
  FractureOptions fracture;  ///< of [fracture]
  std::vector<std::string> warnings;
  std::string resolved;  ///< the case as TOML with defaults and overrides filled in
  bool si = false;       ///< a unit was given somewhere: all numbers are SI
};

/// `overrides` are KEY=VALUE ("bonds.0.young=70e9"; the value as in TOML, a bare word is a string) applied
/// before reading. Throws InputError with every fault found. Paths in `resolved` are written relative to
/// `resolved_folder` where that is not empty. At most `threads` read it, nor more than the case allows its
/// solve; nothing but the time depends on them.
Case read_case(const std::string& file, const std::vector<std::string>& overrides = {},
               const std::string& resolved_folder = "", Purpose purpose = Purpose::statics, int threads = 1);

/// What [calibration] of a case asks for, its other cases read: the arguments of calibrate().
struct CalibrationProblem {
  Case given;                          ///< the case itself without model and outputs: the tests have them
  std::vector<CalibrationTest> tests;  ///< the case, or the case once for each seed, then the other cases
  std::vector<CalibrationParameter> parameters;
  std::vector<CalibrationTarget> targets;  ///< each of one test
  CalibrationOptions options;
  std::vector<std::string> warnings;  ///< of all cases
};

/// `overrides` are of the case itself, not of those beside it. Throws what read_case() throws, and InputError
/// where the case has no [calibration], or where none of its parameters is in a test.
CalibrationProblem read_calibration(const std::string& file, const std::vector<std::string>& overrides = {},
                                    int threads = 1);

/// Content of a case file in `folder`: the case with what calibrate() found in place of its parameters;
/// `values` are in the order of `problem.parameters`.
std::string calibrated_case(const CalibrationProblem& problem, const std::vector<std::string>& overrides,
                            const std::string& folder, const std::vector<double>& values);

}  // namespace bondstatic
