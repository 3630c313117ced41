// Rigid groups that no single joint shows: in a tetrahedron of contacts each pair may roll, yet the four are
// rigid.
#pragma once

#include <vector>

#include "mechanism/partition.hpp"
#include "mechanism/rigid_bodies.hpp"

namespace bondstatic {

inline constexpr Index patch_size =
    120;  ///< bodies: large enough for a rigid core in a packing of six contacts

/// Sets of bodies 0 ... n-1 that can only move as one, the ground being number n, as far as the constraints
/// inside of `patches` neighbourhoods spread over the network show it.
Partition rigid_patches(const std::vector<RigidBody>& bodies, const std::vector<Constraint>& constraints,
                        Index patches);

}  // namespace bondstatic
