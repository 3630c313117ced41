#include <cmath>

#include "bond/codes/codes.hpp"

namespace bondstatic {
namespace {

/// Relative rotation is (Ra wa - Rb wb) / L there: (Ra + Rb) / 2L of wa - wb, and for unequal radii a part of
/// wa + wb, which no bond that rests under rigid motions has.
double moment_factor(const BondSite& site) {
  return 0.5 * (site.radius_a + site.radius_b) / site.length;
}

}  // namespace

BondCode liggghts_bond_gran() {
  return {
      .name = "liggghts-bond-gran",
      .title = "LIGGGHTS-WITH-BONDS, bond_style gran",
      .version = "richti83/LIGGGHTS-WITH-BONDS of October 2015 (source); LIGGGHTS-PUBLIC 3.8 lacks it",
      .stored =
          {{"rb", dimension::none, "bond radius over the smaller particle's", "bond_coeff TYPE, 1st number"},
           {"Sn", dimension::stress_per_length, "normal stiffness per area", "bond_coeff TYPE, 2nd number"},
           {"St", dimension::stress_per_length, "shear stiffness per area", "bond_coeff TYPE, 3rd number"}},
      .formulas = {"r = rb min(Ra, Rb)", "kn = Sn A", "ks = St A", "kt = w St J", "kb = w Sn J / 2",
                   "w = (Ra + Rb) / 2L: one half for touching particles"},
      .contact_point = {ContactPoint::Kind::gap},
      .contact_point_text =
          "lever arms Ra and Rb, which meet at the point of contact of touching particles; "
          "where there is a gap they are taken to its centre here",
      .known_from = "read from the source",
      .shear =
          "incremental: tangential velocity less (Ra wa + Rb wb) x n, times the time step; forces and "
          "moments of a bond are projected to the new normal and plane each step",
      .moments =
          "both act on the particles, and so does R times the shear force; they grow with (Ra wa - Rb "
          "wb)/L, half the relative rotation of touching equal particles",
      .here =
          "law = \"generic\", kn, ks, kt, kb by the formulas above, contact_point = \"gap\"; edem-v2 with "
          "the same numbers is twice as stiff against bending and twisting",
      .fit = section_fit,
      .remarks = {"rb is a factor here, but the examples that come with the code give it a length; other "
                  "versions (LIGGGHTS_Flexible_Fibers) take outer and inner radius and moduli instead.",
                  "Bonds break that come within the neighbour skin of the box.",
                  "The contact model of the pair style acts in addition where particles overlap."},
      .source = "richti83/LIGGGHTS-WITH-BONDS, src/bond_gran.cpp, BondGran::compute and coeff",
      .realised =
          [](const BondSite& site, std::span<const double> in) {
            return on_section(in[1], in[2], in[0] * smaller_radius(site), moment_factor(site));
          },
      .stored_for =
          [](const BondSite& site, const BondProperties& wanted) {
            const FittedSection section = fitted_section(site, wanted, moment_factor(site));
            return std::vector{section.radius / smaller_radius(site), section.normal, section.shear};
          },
      .departure =
          [](const BondSite& site) {
            return std::max(std::abs(site.gap()) / site.length,
                            0.5 * std::abs(site.radius_a - site.radius_b) / site.length);
          },
      .departure_text =
          "turned as a whole, a bond there gets a shear displacement of gap/L, and a relative "
          "rotation of (Ra - Rb)/2L, of the turn (the larger is given); neither is counted here",
  };
}

}  // namespace bondstatic
