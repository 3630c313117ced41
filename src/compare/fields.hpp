// The run beside the static answer, field by field.
#pragma once

#include <vector>

#include "bondstatic/compare.hpp"
#include "bondstatic/network.hpp"

namespace bondstatic {

/// Displacement; rotation, bond forces and energy as far as the run tells them. `motion` is that of the run
/// beyond the cell's `strain`.
std::vector<FieldComparison> compared_fields(const Model& model, const BondNetwork& network,
                                             const State& statics, const RunState& run,
                                             const std::vector<Vector6>& motion, const Matrix3& strain);

/// The particles whose displacements differ most, ten at most.
std::vector<WorstParticle> worst_particles(const State& statics, const RunState& run);

}  // namespace bondstatic
