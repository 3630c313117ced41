// [[calibration.targets]], and the tests that they may be of.
#pragma once

#include "bondstatic/calibration.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// What a test is called: its file as seen from the folder of the calibrated case.
std::string test_name(const std::string& calibrated, const std::string& file);

/// How many numbers the targets are in all tests. The plan has its cases and seeds; of the other cases only
/// the [[outputs]] are looked at.
Index read_calibration_targets(Reading& reading, TableReader& calibration, const std::vector<Output>& outputs,
                               CalibrationPlan& plan);

}  // namespace bondstatic
