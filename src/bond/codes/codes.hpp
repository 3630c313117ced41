// The codes of this build, one function a code; codes.cpp puts them in the order of the listing. And the
// section that codes share which tie four stiffnesses to three numbers.
#pragma once

#include <algorithm>

#include "bond/codes.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {

BondCode pfc_linearpbond();
BondCode edem_bonding_v2();
BondCode lammps_bpm_rotational();
BondCode liggghts_bond_gran();
BondCode yade_cohfrict();
BondCode musen_solid_bond();

/// A round section of radius r with a normal and a shear stiffness per area: the parallel bond of Potyondy
/// and Cundall. `moment_factor` times its rotational stiffnesses is what acts.
inline BondProperties on_section(double normal, double shear, double radius, double moment_factor = 1) {
  const RoundSection<double> section{radius};
  return {.stiffness = {.kn = normal * section.area(),
                        .ks = shear * section.area(),
                        .kt = shear * section.polar_moment() * moment_factor,
                        .kb = normal * section.second_moment() * moment_factor},
          .radius = radius};
}

/// The section that carries what is wanted best: kn, ks and kb as they are, kt follows. Without bending it is
/// twisting that counts; without either, the bond's own radius, else the smaller particle's.
struct FittedSection {
  double normal = 0;  ///< stiffness per area
  double shear = 0;
  double radius = 0;
};
FittedSection fitted_section(const BondSite& site, const BondProperties& wanted, double moment_factor = 1);

inline double smaller_radius(const BondSite& site) {
  return std::min(site.radius_a, site.radius_b);
}

inline constexpr const char* section_fit =
    "kn, ks and kb are met, by the choice of the section's radius; kt follows from ks and that radius";

}  // namespace bondstatic
