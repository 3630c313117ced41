// What relax and check tell of an explicit run of one load case (results/relaxation_parts.hpp).
#pragma once

#include <string>

#include "report/json_value.hpp"
#include "report/page_data.hpp"
#include "report/page_parts.hpp"

namespace bondstatic {

/// Tables, one column a load case: how it came to rest, energies, the plan it was run by. `runs` are a load
/// case each, called `names`.
void put_relaxed_cases(PageRun& run, const std::vector<JsonValue>& runs,
                       const std::vector<std::string>& names, const PageUnits& units);

}  // namespace bondstatic
