// The incremental bond update, [Chen2022] Table 8 with Eq. 1-7, for eight bonds at a time.
#pragma once

#include "dynamics/bond_pack.hpp"

namespace bondstatic {

/// What a pack reads of the bodies, by lane: displacement at the whole step, velocity and spin half a step
/// before it.
struct EndMotions {
  Lanes displacement_a[3], displacement_b[3];
  Lanes velocity_a[3], velocity_b[3];
  Lanes spin_a[3], spin_b[3];
};

/// One step of length `dt`: histories advance, `ends` is what the bonds then do to their bodies.
void advance_bonds(Kinematics kinematics, BondPack& pack, const EndMotions& motions, double dt,
                   EndForces& ends);

/// The same with dashpots; `dissipated` gets what they took in this step, lane by lane.
void advance_bonds(Kinematics kinematics, BondPack& pack, DashpotPack& dashpots, const EndMotions& motions,
                   double dt, EndForces& ends, Lanes& dissipated);

}  // namespace bondstatic
