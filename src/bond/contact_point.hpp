// Moving the point that C refers to.
#pragma once

#include "bondstatic/bond.hpp"

namespace bondstatic {

/// The same bond seen from a contact point `distance` further towards b. With delta_y' = delta_y + s drz and
/// delta_z' = delta_z - s dry (rigid motion of either side), equal energy gives
///
///     ks' = ks     c' = c - s ks     kb' = kb - 2 s c + s^2 ks,
///
/// and ks kb - c^2 does not change.
SectionStiffness moved(const SectionStiffness& stiffness, double distance);

}  // namespace bondstatic
