#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { critical_normal_stress, critical_shear_stress };
enum Mode { tension, shear };

void failure_modes(const BondSection& bond, std::span<const double> in, std::vector<FailureMode>& out) {
  out.push_back(edge_normal_stress(tension, bond.radius, in[critical_normal_stress], bond.fraction));
  out.push_back(edge_shear_stress(shear, bond.radius, in[critical_shear_stress]));
}

}  // namespace

StrengthCriterion edem_v2_strength() {
  return {
      .name = "edem-v2",
      .title = "EDEM Bonding V2, critical stresses",
      .source = "[EDEM-V2]",
      .formulas = {"tension: Fn/A + 2 Mt r/J = critical_normal_stress",
                   "shear: |Ft|/A + |Mn| r/J = critical_shear_stress",
                   "Mt bending moment at the contact point, Mn twisting moment"},
      .parameters = {required_input("critical_normal_stress", dimension::stress,
                                    "critical normal stress: largest that the bond withstands"),
                     required_input("critical_shear_stress", dimension::stress,
                                    "critical shear stress: largest that the bond withstands")},
      .scatters = {true, true},
      .modes = {"tension", "shear"},
      .remark =
          "Compression does not break a bond unless its bending moment pulls one edge open. EDEM's page "
          "gives "
          "no contact point: the bond's own is taken. Stresses as in the bonds' columns sigma and tau.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
