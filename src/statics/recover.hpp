// From the motion of the particles back to what the user asked for: reactions, bond resultants, energy,
// balances.
#pragma once

#include "bondstatic/statics.hpp"
#include "statics/refine.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// Everything is formed from the motion in extended precision and rounded once: the shear force of a slender
/// chain is a difference of displacements 10^12 times as large. On several ranks, reactions are those of own
/// bodies, energy, work and balances those of all.
LoadCaseResult recover(const Model& model, const BondNetwork& network, const Incidence& incidence,
                       const std::vector<BondProperties>& properties, const Boundary& boundary,
                       const std::vector<bool>& left_out, const Refined& refined, int threads,
                       Ranks* ranks = nullptr);

}  // namespace bondstatic
