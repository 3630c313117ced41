// Inputs that several laws share.
#pragma once

#include <algorithm>

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

Parameter young_input();
Parameter poisson_input();        ///< -1 < nu <= 0.5
Parameter radius_input();         ///< one way to say the bond radius ...
Parameter radius_factor_input();  ///< ... and the other, 1 by default
Parameter stress_radius_input();  ///< of laws whose stiffness needs no section

/// An input that must be given, positive unless `zero_allowed`.
Parameter required_input(std::string name, Dimension dimension, std::string meaning,
                         bool zero_allowed = false);

/// An input that may be left out because something else can take its place.
Parameter optional_input(Parameter input);

/// The two ways to say the bond radius.
Alternatives radius_ways();

/// Bond radius as given, else factor * min(Ra, Rb) ([Chen2022] section 2.1).
template <class T>
T bond_radius(const BondSite& site, const T& radius, const T& radius_factor) {
  return radius > 0 ? radius : radius_factor * std::min(site.radius_a, site.radius_b);
}

}  // namespace bondstatic
