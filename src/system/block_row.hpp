// One body's rows of K as 6x6 blocks, both triangles: what a solver that keeps its matrix by rows, or only
// some of its rows, assembles from. Rotations times network.rotation_length, as in assemble.hpp.
//
// All six rows of a body stand, so that blocks are alike: a held unknown keeps its diagonal entry (of the
// size that the matrix has around it) and loses the rest of its row and column. With zero on the right it
// stays zero.
#pragma once

#include <utility>
#include <vector>

#include "system/incidence.hpp"

namespace bondstatic {

/// Neighbours ascending, the body itself among them, and their blocks. A held unknown whose own entry is
/// zero (nothing resists it) gets one on the diagonal.
using BlockRow = std::vector<std::pair<Index, Matrix6>>;

/// Overwrites `row`. The blocks of (p, q) and (q, p) are each other's transpose to the last bit.
void block_row(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs, Index body,
               BlockRow& row);

}  // namespace bondstatic
