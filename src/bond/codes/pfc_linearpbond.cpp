#include "bond/codes/codes.hpp"

namespace bondstatic {

BondCode pfc_linearpbond() {
  return {
      .name = "pfc-linearpbond",
      .title = "Itasca PFC, linear parallel bond model (linearpbond), its bonded part",
      .version = "PFC 6.0 and 7.0 (documentation)",
      .stored = {{"pb_kn", dimension::stress_per_length, "normal stiffness per area", "property pb_kn"},
                 {"pb_ks", dimension::stress_per_length, "shear stiffness per area", "property pb_ks"},
                 {"pb_rmul", dimension::none, "bond radius over the smaller particle's", "property pb_rmul"}},
      .formulas = {"r = pb_rmul min(Ra, Rb)", "kn = pb_kn A", "ks = pb_ks A", "kt = pb_ks J", "kb = pb_kn I",
                   "pb_deformability emod E*, kratio k*: pb_kn = E* / (Ra + Rb), pb_ks = pb_kn / k*"},
      .contact_point = {ContactPoint::Kind::gap},
      .contact_point_text =
          "centre of the gap, a = (L + Ra - Rb)/2: the bond's section is centred at the "
          "contact point",
      .known_from =
          "documented that the section is centred at the contact point; where that lies between two "
          "balls is taken from [Chen2022] Eq. 1",
      .shear = "incremental: relative shear displacement at the contact point, step by step",
      .moments =
          "twisting and bending moments grow with the relative rotation and act on the particles, as "
          "does the moment of the force about their centres",
      .here =
          "law = \"pfc-parallel\", normal_stiffness = pb_kn, shear_stiffness = pb_ks, radius_factor = "
          "pb_rmul",
      .fit = section_fit,
      .remarks =
          {"The linear springs kn, ks of the same contact act beside the bond where the surfaces "
           "touch; what is translated is the bond alone: set kn = ks = 0, or count them in.",
           "pb_mcf, the moment-contribution factor, enters the stresses that break a bond, not its "
           "stiffness.",
           "A bond without moments is PFC's linear contact bond (linearcbond: kn, ks), not this model."},
      .source =
          "docs.itascacg.com, pfc600/.../linearpbond/doc/manual/cmlinearpbond.html and "
          "pfc700/.../def_linearpbond_property.html; Potyondy & Cundall 2004; [Chen2022] section 2.1",
      .realised =
          [](const BondSite& site, std::span<const double> in) {
            return on_section(in[0], in[1], in[2] * smaller_radius(site));
          },
      .stored_for =
          [](const BondSite& site, const BondProperties& wanted) {
            const FittedSection section = fitted_section(site, wanted);
            return std::vector{section.normal, section.shear, section.radius / smaller_radius(site)};
          },
  };
}

}  // namespace bondstatic
