#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { critical_tensile_force, critical_shear_force };
enum Mode { tension, shear };

void failure_modes(const BondSection&, std::span<const double> in, std::vector<FailureMode>& out) {
  out.push_back({.name = tension, .normal = 1 / in[critical_tensile_force]});
  out.push_back({.name = shear, .shear = 1 / in[critical_shear_force]});
}

}  // namespace

StrengthCriterion contact_bond_strength() {
  return {
      .name = "contact-bond",
      .title = "contact bond: tensile and shear force",
      .source = "Itasca PFC, linear contact bond model (cb_tenf, cb_shearf); Potyondy & Cundall 2004",
      .formulas = {"tension: N = critical_tensile_force", "shear: |S| = critical_shear_force"},
      .parameters = {required_input("critical_tensile_force", dimension::force,
                                    "cb_tenf: tensile strength, a force"),
                     required_input("critical_shear_force", dimension::force,
                                    "cb_shearf: shear strength, a force")},
      .scatters = {true, true},
      .modes = {"tension", "shear"},
      .needs_section = false,
      .remark = "Moments do not count. Friction after a break in shear is not here.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
