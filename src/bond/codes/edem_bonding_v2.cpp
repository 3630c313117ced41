#include "bond/codes/codes.hpp"

namespace bondstatic {

BondCode edem_bonding_v2() {
  return {
      .name = "edem-bonding-v2",
      .title = "Altair EDEM, Bonding V2",
      .version = "documentation as of 2025",
      .stored = {{"normal_stiffness", dimension::stress_per_length, "Sn, per area",
                  "Normal Stiffness per unit area"},
                 {"shear_stiffness", dimension::stress_per_length, "St, per area",
                  "Shear Stiffness per unit area"},
                 {"disk_scale", dimension::none, "bond radius over the smaller particle's",
                  "Bonded Disk Scale"},
                 {"torque_feedback", dimension::none, "whether the bond's moments act on the particles",
                  "Torque Feedback", true}},
      .formulas = {"r = disk_scale min(Ra, Rb)", "kn = Sn A", "ks = St A", "kt = St J", "kb = Sn J / 2",
                   "torque feedback off: kt = kb = 0 as far as the particles feel"},
      .contact_point = {ContactPoint::Kind::gap},
      .contact_point_text = "centre of the gap, a = (L + Ra - Rb)/2",
      .known_from = "not documented; assumed, as the model rests on Potyondy & Cundall's",
      .shear = "incremental: tangential velocity times the time step",
      .moments =
          "with torque feedback they act on the particles; without, as read here, they only enter the "
          "stresses, while the moment of the shear force about the centres acts",
      .here = "law = \"edem-v2\", normal_stiffness, shear_stiffness, disk_scale, torque_feedback",
      .fit = section_fit,
      .remarks =
          {"Bonds act in addition to the base contact model: where particles overlap, that adds "
           "stiffness.",
           "Normal and Tangential Range scatter Sn and St from bond to bond; what is translated has its "
           "own values, ranges 0.",
           "A bond holds only within the contact radius, which must be larger than the physical one."},
      .source = "[EDEM-V2], help.altair.com/EDEM/topics/creator_tree_physics/the_bonding_v2_model_r.htm",
      .realised =
          [](const BondSite& site, std::span<const double> in) {
            BondProperties out = on_section(in[0], in[1], in[2] * smaller_radius(site));
            out.moments_fed_back = in[3] != 0;
            return out;
          },
      .stored_for =
          [](const BondSite& site, const BondProperties& wanted) {
            const FittedSection section = fitted_section(site, wanted);
            const bool moments = wanted.stiffness.kt > 0 || wanted.stiffness.kb > 0;
            return std::vector{section.normal, section.shear, section.radius / smaller_radius(site),
                               moments && wanted.moments_fed_back ? 1.0 : 0.0};
          },
  };
}

}  // namespace bondstatic
