// The states of a run to rest: a series for each load case.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/relaxation.hpp"
#include "results/state_series.hpp"

namespace bondstatic {

inline constexpr const char* relaxation_kind = "relax";

/// Those that a load case has shown, in the folder of the run's results.
StateSeries relaxation_series(const Model& model, const std::string& load_case,
                              const std::vector<SavedState>& saved, const std::string& folder);

}  // namespace bondstatic
