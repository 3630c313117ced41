// The afternoon version of the explicit run: one object a bond, one bond after another, Eigen's small
// vectors.
#pragma once

#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic::bench {

/// Displacements after so many steps of finite kinematics under the loads of the first load case, particle
/// damping 0.7, no ramp.
std::vector<Vector3> run_naively(const Model& model, const std::vector<BondProperties>& properties,
                                 double time_step, int steps);

}  // namespace bondstatic::bench
