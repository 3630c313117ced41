// [[calibration.parameters]].
#pragma once

#include "bondstatic/calibration.hpp"
#include "case/draft.hpp"

namespace bondstatic {

void read_calibration_parameters(Draft& draft, Node* list, CalibrationPlan& plan);

}  // namespace bondstatic
