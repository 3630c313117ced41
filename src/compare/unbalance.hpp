// How far from rest a run's state is, by what it carries and by what it says of itself.
#pragma once

#include <vector>

#include "bondstatic/compare.hpp"
#include "bondstatic/modes.hpp"
#include "bondstatic/network.hpp"
#include "model/boundary.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// f less what bonds of finite kinematics ask for.
BodyVectors<double> finite_residual(const BondNetwork& network, const Boundary& boundary,
                                    const BodyVectors<double>& motion);

/// All but still_moves and slow_modes. `motion` is that of the run, or empty where its rotations are not
/// known.
Unbalance unbalance_of(const Model& model, const BondNetwork& network, const Boundary& boundary,
                       const State& statics, const RunState& run, const BodyVectors<double>& motion);

/// Share of the accelerations M^-1 r, in the norm of M, that these modes have.
double share_of_modes(const std::vector<Mode>& modes, const BodyMasses& masses, const FreeDofs& dofs,
                      const BodyVectors<double>& residual);

/// Of the particles; of spheres of one density where some particle has none.
BodyMasses masses_or_volumes(const Model& model);

}  // namespace bondstatic
