// The strength criteria of this build, one function a criterion; catalogue.cpp puts them in the order of the
// listing. Stresses are those of a solid round section of radius r, tension positive.
#pragma once

#include "bond/laws/inputs.hpp"
#include "bond/laws/round_section.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

StrengthCriterion edem_v2_strength();
StrengthCriterion pfc_parallel_strength();
StrengthCriterion brown_strength();
StrengthCriterion musen_strength();
StrengthCriterion bpm_rotational_strength();
StrengthCriterion contact_bond_strength();

/// The normal stress at the edge, +-N/A + share M r/I at `at`, over `strength`.
inline FailureMode edge_normal_stress(int name, double radius, double strength, double at, double sign = 1,
                                      double share = 1) {
  const RoundSection<double> section{radius};
  return {.name = name,
          .normal = sign / (section.area() * strength),
          .bending = share * radius / (section.second_moment() * strength),
          .at = at};
}

/// The shear stress at the edge, factor |S|/A + share |T| r/J, over `strength`.
inline FailureMode edge_shear_stress(int name, double radius, double strength, double factor = 1,
                                     double share = 1) {
  const RoundSection<double> section{radius};
  return {.name = name,
          .shear = factor / (section.area() * strength),
          .twisting = share * radius / (section.polar_moment() * strength)};
}

}  // namespace bondstatic
