// Load over displacement of a run of fracture.
#pragma once

#include "bondstatic/results.hpp"
#include "results/plot.hpp"

namespace bondstatic {

/// The curve runs through the states just before and just after each event, straight between, as it is. A
/// disc is an event; that of the first one of an avalanche is as large as the avalanche is long.
Plot fracture_plot(const Model& model, const RunInfo& run, const FractureOptions& asked,
                   const Fracture& fracture);

}  // namespace bondstatic
