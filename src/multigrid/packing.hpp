// A level of the multigrid as a bonded packing: bodies, the links between them, and what ties them to the
// ground.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "multigrid/halo.hpp"
#include "multigrid/rigid_link.hpp"
#include "system/incidence.hpp"

namespace bondstatic::multigrid {

/// All six degrees of freedom of a body, as bits.
inline constexpr std::uint8_t all_free = 0x3f;

/// The unit of length is that of the unknowns (rotations times network.rotation_length), the unit of
/// stiffness the stiffest bond: numbers keep far from the limits of float whatever units the model has. Links
/// above the finest level are in these units already.
struct Units {
  double length = 1;
  double stiffness = 1;
};

inline Link in_units(const Link& link, const Units& units) {
  const SectionStiffness& c = link.stiffness;
  const double one = 1 / units.stiffness, square = one / (units.length * units.length);
  return {link.a,
          link.b,
          link.branch / units.length,
          link.fraction,
          {one * c.kn, one * c.ks, square * c.kt, square * c.kb, one / units.length * c.coupling}};
}
template <class Scalar>
const RigidLink<Scalar>& in_units(const RigidLink<Scalar>& link, const Units&) {
  return link;
}

/// A body's tie to the ground, felt at its centre.
struct Spring {
  Index body = 0;
  Matrix6 stiffness;
};

/// LinkType is Link on the finest level and RigidLink above it. Links are seen, not owned.
template <class LinkType>
struct Packing {
  Index bodies = 0;  ///< copies of other ranks' bodies at the end of them included
  Index own = 0;     ///< bodies 0 ... own-1 are not copies
  std::span<const LinkType> links;
  const Incidence* incidence = nullptr;  ///< links by body; of a copy, not all
  Units units;
  std::vector<bool> held;           ///< bodies that are part of the ground; empty: none is
  std::span<const Spring> springs;  ///< ascending bodies
  const Halo* halo = nullptr;       ///< bodies; set in every packing

  bool is_held(Index body) const { return !held.empty() && held[std::size_t(body)]; }
  Index other_end(Index link, Index body) const {
    const LinkType& l = links[std::size_t(link)];
    return l.a == body ? l.b : l.a;
  }
  decltype(auto) link(Index k) const { return in_units(links[std::size_t(k)], units); }

  /// Null where the body has none.
  const Spring* spring_of(Index body) const;
};

/// The sum of what a body's links do against its own motion, springs left out: sum of G^T C G.
template <class LinkType>
Matrix6 links_felt_at(const Packing<LinkType>& packing, Index body) {
  Felt<LinkType> felt;
  for (const Index k : packing.incidence->of(body)) {
    const auto& link = packing.link(k);
    felt.add(link, link.a == body);
  }
  return felt.sum();
}

/// The network's own packing: bodies without unknowns are ground. `springs` gets one for each particle that
/// is held in some of its degrees of freedom, in these: the finest level leaves such degrees of freedom out
/// and ignores the springs; clumps, which only move as a whole, feel them instead. `halo` gets what the
/// network shares.
Packing<Link> finest_packing(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                             std::vector<Spring>& springs, Halo& halo);

template <class LinkType>
const Spring* Packing<LinkType>::spring_of(Index body) const {
  const auto found = std::lower_bound(springs.begin(), springs.end(), body,
                                      [](const Spring& s, Index b) { return s.body < b; });
  return found != springs.end() && found->body == body ? &*found : nullptr;
}

}  // namespace bondstatic::multigrid
