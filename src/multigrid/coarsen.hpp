// The next coarser packing: each clump becomes a body, all links between two clumps become one link.
#pragma once

#include <vector>

#include "multigrid/clumps.hpp"

namespace bondstatic::multigrid {

/// A packing that owns its links.
template <class Scalar>
struct CoarsePacking {
  Index bodies = 0, own = 0;
  std::vector<RigidLink<Scalar>> links;
  Incidence incidence;
  std::vector<Spring> springs;
  Halo halo;

  Packing<RigidLink<Scalar>> view() const { return {bodies, own, links, &incidence, {}, {}, springs, &halo}; }
};

/// Where a clump's members stand, from the clump's centre (the mean of theirs): walked along the branches of
/// the links inside the clump, so that no positions are needed and images of a periodic cell do no harm. By
/// body; zero for bodies without a clump.
template <class LinkType>
std::vector<Vector3> offsets_in_clumps(const Packing<LinkType>& packing, const Clumps& clumps, int threads);

/// Galerkin's product P^T K P with P the rigid motions of the clumps, formed from the links between clumps
/// alone: those inside have no say, exactly. What ties a clump's members to the ground becomes its spring.
template <class Scalar, class LinkType>
CoarsePacking<Scalar> coarsen(const Packing<LinkType>& packing, const Clumps& clumps,
                              const std::vector<Vector3>& offsets, int threads);

}  // namespace bondstatic::multigrid
