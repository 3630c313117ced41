// What bonds and supports forbid, stripped of all stiffness: unit wrenches between rigid bodies. Such a
// wrench (force f at a point, moment m) forbids the relative motion f . (v_b - v_a) + m . (omega_b -
// omega_a), v being the velocity of each body at the point.
#pragma once

#include <vector>

#include "bondstatic/network.hpp"

namespace bondstatic {

inline constexpr Index ground = -1;  ///< the body that supports hold on to

struct Constraint {
  Index a = ground;
  Index b = 0;
  Vector3 at_a = Vector3::Zero();  ///< the point as body a sees it
  Vector3 at_b = Vector3::Zero();  ///< the same, but for the image shift of a bond through a periodic face
  Vector3 force = Vector3::Zero();
  Vector3 moment = Vector3::Zero();
  bool shifted = false;  ///< at_a and at_b are different points
};

/// Does the branch vector go round a periodic cell, so that it is not the difference of the two positions?
bool is_shifted(const Link& link, const Vector3& position_a, const Vector3& position_b);

/// Does the link alone make its two bodies one? It resists every relative motion and is not shifted.
bool is_rigid(const Link& link, const Vector3& position_a, const Vector3& position_b);

/// Appends one constraint for each relative motion that C resists; `a` and `b` are the bodies of link.a,
/// link.b.
void append_constraints(std::vector<Constraint>& constraints, const Link& link, Index a, Index b,
                        const Vector3& position_a, const Vector3& position_b);

/// Appends one constraint to the ground for each degree of freedom that is not in the mask `free`.
void append_support(std::vector<Constraint>& constraints, Index body, const Vector3& position,
                    std::uint8_t free);

/// The constraint's linear form of a body's scaled motion (v at `centre`, size * omega), given the point as
/// the body sees it; body a takes it with a minus.
Vector6 wrench_on(const Constraint& constraint, const Vector3& at, const Vector3& centre, double size);

}  // namespace bondstatic
