// The states of a run of fracture: their times are the events that had happened by then.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/results.hpp"
#include "io/column.hpp"
#include "results/state_series.hpp"

namespace bondstatic {

inline constexpr const char* fracture_kind = "fracture";

/// break_step and utilisation.
std::vector<Column> fracture_columns(const Model& model, const State& state,
                                     const std::vector<Index>& break_event);

/// Those that the run has shown, in the folder of its results.
StateSeries fracture_series(const FractureRecord& record, const std::string& folder);

}  // namespace bondstatic
