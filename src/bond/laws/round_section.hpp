// A solid round section of radius r, and the shear modulus of an isotropic material.
#pragma once

#include <numbers>

namespace bondstatic {

template <class T>
struct RoundSection {
  T radius = 0;

  T area() const { return std::numbers::pi * radius * radius; }        ///< A
  T second_moment() const { return 0.25 * area() * radius * radius; }  ///< I
  T polar_moment() const { return 0.5 * area() * radius * radius; }    ///< J = 2 I
};

/// G = E / 2(1 + nu)
template <class T>
T shear_modulus(const T& young, const T& poisson) {
  return young / (2 * (1 + poisson));
}

/// 1/k of the shear correction of a round section: w' = fs F / GA ([Chen2022] Eq. 27).
inline constexpr double round_form_factor = 10.0 / 9.0;

}  // namespace bondstatic
