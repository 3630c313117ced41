#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { compressive_strength, tensile_strength, shear_strength, shear_factor };
enum Mode { compression, tension, shear };

void failure_modes(const BondSection& bond, std::span<const double> in, std::vector<FailureMode>& out) {
  for (const double end : {0.0, 1.0}) {
    out.push_back(edge_normal_stress(compression, bond.radius, in[compressive_strength], end, -1));
    out.push_back(edge_normal_stress(tension, bond.radius, in[tensile_strength], end));
  }
  // The shear force and the twisting moment are the same at both ends.
  out.push_back(edge_shear_stress(shear, bond.radius, in[shear_strength], in[shear_factor]));
}

std::vector<Parameter> inputs() {
  Parameter factor =
      required_input("shear_factor", dimension::none,
                     "largest over mean shear stress of the shear force: 4/3 in a round section", true);
  factor.lower = 1;
  factor.default_value = 4.0 / 3.0;
  return {optional_input(required_input("compressive_strength", dimension::stress,
                                        "compressive strength of the bond, infinite where left out")),
          required_input("tensile_strength", dimension::stress, "tensile strength of the bond"),
          required_input("shear_strength", dimension::stress, "shear strength of the bond"), factor};
}

}  // namespace

StrengthCriterion brown_strength() {
  return {
      .name = "brown",
      .title = "Timoshenko beam bond model, TBBM: stresses at both ends of the beam",
      .source = "Brown, Chen & Ooi, Granular Matter 16 (2014) 299",
      .formulas = {"compression: -N/A + M r/I = compressive_strength, at the centre of either particle",
                   "tension: N/A + M r/I = tensile_strength, likewise",
                   "shear: shear_factor |S|/A + |T| r/J = shear_strength"},
      .parameters = inputs(),
      .scatters = {true, true, true, false},
      .modes = {"compression", "tension", "shear"},
      .remark =
          "The published factor of the shear force is not known to this program, so shear_factor is an "
          "input; 4/3 is beam theory's for a round section. The model draws its strengths about their means, "
          "which is scatter = \"normal\" with the coefficient of variation.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
