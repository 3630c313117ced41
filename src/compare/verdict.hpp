// What the figures of a comparison say.
#pragma once

#include "bondstatic/compare.hpp"
#include "model/boundary.hpp"

namespace bondstatic {

/// What a verdict needs beside the figures that are told.
struct Evidence {
  double difference = not_given;  ///< |u - u_static| over |u_static|, as the suspects are measured
  double supports = 0;  ///< how far prescribed degrees of freedom are from what the case says, likewise
};

/// Displacement and rotation within the tolerance, and the run not on its way through.
bool within_tolerance(const Comparison& comparison);

/// Root mean square over the prescribed translations, over that of all static translations.
double support_deviation(const Model& model, const State& statics, const Boundary& boundary,
                         const RunState& run);

/// Fills in verdict and reason.
void judge(Comparison& comparison, const Evidence& evidence);

}  // namespace bondstatic
