#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { tensile_strength, cohesion, friction_angle, moment_contribution };
enum Mode { tension, shear };

void failure_modes(const BondSection& bond, std::span<const double> in, std::vector<FailureMode>& out) {
  const double share = in[moment_contribution];
  out.push_back(edge_normal_stress(tension, bond.radius, in[tensile_strength], bond.fraction, 1, share));
  FailureMode sliding = edge_shear_stress(shear, bond.radius, in[cohesion], 1, share);
  sliding.normal = std::tan(in[friction_angle]) * sliding.shear;
  out.push_back(sliding);
}

std::vector<Parameter> inputs() {
  // Radians as all angles of a case, so that "30 deg" means what it says; PFC's own 30 is out of bounds.
  Parameter angle = required_input("friction_angle", dimension::none,
                                   "pb_fa: friction angle of the bond, in radians or as \"30 deg\"", true);
  angle.default_value = 0;
  angle.upper = 1.55;
  Parameter share = required_input("moment_contribution", dimension::none,
                                   "pb_mcf: part beta of the moments that enters the stresses", true);
  share.default_value = 1;
  share.upper = 1;
  return {required_input("tensile_strength", dimension::stress, "pb_ten: tensile strength of the bond"),
          required_input("cohesion", dimension::stress, "pb_coh: cohesion of the bond"), angle, share};
}

}  // namespace

StrengthCriterion pfc_parallel_strength() {
  return {
      .name = "pfc-parallel",
      .title = "linear parallel bond of PFC: tensile strength, cohesion and friction angle",
      .source =
          "Itasca PFC documentation, Linear Parallel Bond Model (pb_ten, pb_coh, pb_fa, pb_mcf); Potyondy & "
          "Cundall 2004",
      .formulas = {"tension: sigma_n + beta M r/I = tensile_strength",
                   "shear: |S|/A + beta |T| r/J = cohesion - sigma_n tan(friction_angle)",
                   "sigma_n = N/A, mean normal stress, tension positive; moments at the contact point"},
      .parameters = inputs(),
      .scatters = {true, true, false, false},
      .modes = {"tension", "shear"},
      .remark =
          "The utilisation in shear is (tau + sigma_n tan(friction_angle)) / cohesion: 1 exactly where tau "
          "reaches PFC's shear strength, and a sum of the bond's forces, where tau over that strength is "
          "none. PFC's own parallel bond force is positive in compression; its linear contact beside the "
          "bond, and sliding after the break, are not here.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
