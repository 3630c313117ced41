// What calibration.json tells, as curves.
#pragma once

#include "report/json_value.hpp"
#include "report/page_data.hpp"

namespace bondstatic {

void put_targets_plots(PageRun& run, const JsonValue& calibration);
void put_parameter_plot(PageRun& run, const JsonValue& calibration);
void put_calibration_history(PageRun& run, const JsonValue& calibration);

}  // namespace bondstatic
