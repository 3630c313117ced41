// Between bodies, six numbers one after another, and lanes, where each number of eight bonds lies together:
// four bodies at a time, by transposing four-by-four blocks in registers.
#pragma once

#include "dynamics/advance_bonds.hpp"
#include "dynamics/bodies.hpp"

namespace bondstatic {

/// What the bonds of a pack read of their bodies; displacements only where `displaced`.
void read_motions(const BondPack& pack, const Bodies& bodies, bool displaced, EndMotions& motions);

/// Adds what they do to their bodies, bond after bond and a before b.
void add_forces(const BondPack& pack, const EndForces& ends, Bodies& bodies);

}  // namespace bondstatic
