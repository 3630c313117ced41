// Small models with outputs whose laws' parameters are calibrated.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "bondstatic/calibration.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

/// Ten bonds of 0.1 along x, held at the first particle; loads across, along and about x at the last, each a
/// case, or all three in one. Outputs: tip, middle (uy), stretch, half_stretch (ux), twist (rx), pull
/// (reaction along x over the load); twist is left out where `without_twist`.
CalibrationTest cantilever_test(const std::string& law, const Values& values, bool without_twist = false);

/// A disordered packing between two plates: moved down, across, and turned. Outputs are reactions.
CalibrationTest packing_test(const std::string& law, const Values& values);

/// A parameter of block 0, by its law's name.
std::vector<BlockParameter> moves(const CalibrationTest& test, const std::string& parameter);

/// Values of all outputs.
std::vector<double> outputs_of(const CalibrationTest& test);

/// A target for each output; the tolerance is relative, NaN for none.
std::vector<CalibrationTarget> targets_of(const CalibrationTest& test, const std::vector<double>& wanted,
                                          double tolerance);

/// Two parameters of a law, and a test that tells them apart.
struct Known {
  std::string name;
  std::vector<std::string> names;
  std::vector<double> truth, start, lower, upper;
  std::function<CalibrationTest(const std::vector<double>&)>
      test;  ///< with these values; `parameters` filled

  std::vector<CalibrationParameter> parameters() const;
  friend void PrintTo(const Known& known, std::ostream* out) { *out << known.name; }
};

std::vector<Known> known_parameters();

}  // namespace bondstatic::test
