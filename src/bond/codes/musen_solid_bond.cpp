#include "bond/codes/codes.hpp"

namespace bondstatic {

BondCode musen_solid_bond() {
  return {
      .name = "musen-solid-bond",
      .title = "MUSEN, solid bond with the model \"Elastic bond\"",
      .version = "msolids/musen of 2020 and later (source)",
      .stored = {{"diameter", dimension::length, "of the bond", "diameter of the solid bond"},
                 {"young", dimension::stress, "Young's modulus E of the bond's compound",
                  "compound property Young's modulus"},
                 {"poisson", dimension::none, "Poisson's ratio nu of the bond's compound",
                  "compound property Poisson ratio"}},
      .formulas = {"r = diameter / 2, G = E / (2 (1 + nu))", "kn = E A / L", "ks = G A / L", "kt = G J / L",
                   "kb = E I / L", "L: initial distance of the particle centres"},
      .contact_point = {ContactPoint::Kind::beam},
      .contact_point_text = "middle of the bond, a = L/2",
      .known_from = "read from the source",
      .shear = "incremental, turned with the bond and its mean spin each step; the normal force is total",
      .moments = "incremental; both act on the particles, as does half the bond vector times the shear force",
      .here = "law = \"obermayr\", shear_coefficient = 1, young, poisson, radius = diameter / 2",
      .fit =
          "kn, ks and kb are met, by the choice of the diameter; kt follows from ks and that diameter, and "
          "Poisson's ratio is whatever ks asks for",
      .remarks = {"Shear is not reduced: a slender Timoshenko or Euler-Bernoulli bond asks for a Poisson's "
                  "ratio beyond 0.5, which no material has; whether the program takes it is not documented.",
                  "One compound a pair of moduli: bonds whose moduli differ need compounds of their own.",
                  "Other solid bond models of MUSEN (Kelvin, creep, plastic, ...) are not described here."},
      .source =
          "msolids/musen, Models/SolidBonds/BondModelElastic/ModelSBElastic.cpp, "
          "Modules/SimplifiedScene/SimplifiedScene.cpp, CSolidBond::UpdatePrecalculatedValues",
      .realised =
          [](const BondSite& site, std::span<const double> in) {
            return on_section(in[1] / site.length, shear_modulus(in[1], in[2]) / site.length, 0.5 * in[0]);
          },
      .stored_for =
          [](const BondSite& site, const BondProperties& wanted) {
            const FittedSection section = fitted_section(site, wanted);
            return std::vector{2 * section.radius, section.normal * site.length,
                               0.5 * section.normal / section.shear - 1};
          },
  };
}

}  // namespace bondstatic
