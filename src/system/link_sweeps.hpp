// Sweeps over all links in extended precision, four links at a time: what bond.hpp and natural_form.hpp say
// of one link, many times faster. The axis is nowhere normalised: e (e . d) is branch (branch . d) /
// branch^2.
#pragma once

#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// Takes B^T C (B u + strain) from the forces at the bodies: what gather_forces() makes of link_resultants(),
/// but for the last bits of Extended, and in bits that do not depend on `threads`.
void subtract_carried_forces(const BondNetwork& network, const BodyVectors<Extended>& motion,
                             const Matrix3& strain, int threads, BodyVectors<Extended>& forces);

/// delta = B u + strain and q = C delta of a link.
struct LinkState {
  Vector6T<Extended> delta, q;
};
/// Of links first ... last-1, a piece of what many threads share.
void link_states(const BondNetwork& network, const BodyVectors<Extended>& motion, const Matrix3& strain,
                 Index first, Index last, LinkState* found);

/// A motion of the links, of which epsilon . (dC/dc) delta is asked: epsilon = B `motion` + `of_motion` delta
/// + `own`, the last two one a link. Where `kept` is zero only `own` is for twisting and bending, else it is
/// 1.
struct LinkEpsilon {
  const BodyVectors<Extended>& motion;
  const std::vector<double>& of_motion;
  const BodyVectors<double>& own;
  const std::vector<double>& kept;
};

/// epsilon . (dC/dc) delta of each link for each number c of C, with delta = B u + strain.
std::vector<SectionStiffness> stiffness_products(const BondNetwork& network,
                                                 const BodyVectors<Extended>& motion, const Matrix3& strain,
                                                 const LinkEpsilon& epsilon, int threads);

}  // namespace bondstatic
