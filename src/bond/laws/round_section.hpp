// A solid round section of radius r, and the shear modulus of an isotropic material.
#pragma once

#include <numbers>

namespace bondstatic {

struct RoundSection {
  double radius = 0;

  double area() const { return std::numbers::pi * radius * radius; }        ///< A
  double second_moment() const { return 0.25 * area() * radius * radius; }  ///< I
  double polar_moment() const { return 0.5 * area() * radius * radius; }    ///< J = 2 I
};

/// G = E / 2(1 + nu)
inline double shear_modulus(double young, double poisson) {
  return young / (2 * (1 + poisson));
}

/// 1/k of the shear correction of a round section: w' = fs F / GA ([Chen2022] Eq. 27).
inline constexpr double round_form_factor = 10.0 / 9.0;

}  // namespace bondstatic
