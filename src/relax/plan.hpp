// Before the first step: time step, ramp, and how long it will take.
#pragma once

#include "bondstatic/relaxation.hpp"
#include "model/boundary.hpp"
#include "statics/held.hpp"

namespace bondstatic {

/// All that a plan is made from.
struct PlanInput {
  const Model& model;
  const BondNetwork& network;
  std::span<const BondProperties> properties;
  const Boundary& boundary;
  const Held& held;
};

/// Throws MemoryError where the factor for the slowest modes does not fit and the times that come from them
/// are not given.
DynamicPlan plan_run(const PlanInput& input, const RelaxOptions& options, const StaticOptions& solve,
                     int threads);

}  // namespace bondstatic
