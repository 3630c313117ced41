// Which bodies move together: clumps of neighbours that strong links hold.
#pragma once

#include <vector>

#include "multigrid/packing.hpp"

namespace bondstatic::multigrid {

inline constexpr Index no_clump = -1;

struct Clumps {
  Index count = 0;        ///< of own bodies
  std::vector<Index> of;  ///< clump of each body; no_clump: part of the ground, or linked to nothing else
  Index copies = 0;       ///< clumps of copies: count ... count + copies - 1
  std::vector<Neighbour> neighbours;  ///< what clumps other ranks know, as bodies of the coarser packing
};

/// A body and its strongly linked neighbours make a clump where none of them belongs to one yet; what is left
/// over joins the clump that it is tied to the strongest. Bodies are taken breadth first, so that clumps are
/// formed beside each other and leave few gaps. Clumps are connected by links, and keep to one rank.
template <class LinkType>
Clumps form_clumps(const Packing<LinkType>& packing, int threads);

/// Own members of each own clump, ascending.
Incidence members_of(const Clumps& clumps);

extern template Clumps form_clumps(const Packing<Link>&, int);
extern template Clumps form_clumps(const Packing<RigidLink<float>>&, int);
extern template Clumps form_clumps(const Packing<RigidLink<double>>&, int);

}  // namespace bondstatic::multigrid
