#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t {
  critical_normal_force,
  critical_shear_force,
  critical_twisting_moment,
  critical_bending_moment
};

void failure_modes(const BondSection&, std::span<const double> in, std::vector<FailureMode>& out) {
  // LAMMPS adds r/2 x shear force apart from its bending torque: that is the moment in the middle.
  out.push_back({.name = 0,
                 .normal = 1 / in[critical_normal_force],
                 .shear = 1 / in[critical_shear_force],
                 .twisting = 1 / in[critical_twisting_moment],
                 .bending = 1 / in[critical_bending_moment],
                 .at = 0.5});
}

}  // namespace

StrengthCriterion bpm_rotational_strength() {
  return {
      .name = "bpm-rotational",
      .title = "LAMMPS, bond_style bpm/rotational: sum of four ratios",
      .source = "docs.lammps.org/bond_bpm_rotational.html; lammps/lammps, src/BPM/bond_bpm_rotational.cpp",
      .formulas = {"combined: N/f_rc + |S|/f_sc + |T|/tau_tc + |M|/tau_bc = 1",
                   "M in the middle of the bond, N positive in tension"},
      .parameters =
          {required_input("critical_normal_force", dimension::force, "f_rc: critical tensile force"),
           required_input("critical_shear_force", dimension::force, "f_sc: critical shear force"),
           required_input("critical_twisting_moment", dimension::moment, "tau_tc: critical twisting moment"),
           required_input("critical_bending_moment", dimension::moment, "tau_bc: critical bending moment")},
      .scatters = {true, true, true, true},
      .modes = {"combined"},
      .needs_section = false,
      .remark =
          "One sum, so one mode: which term leads says nothing of a crack's kind. Compression counts "
          "negative and holds the bond together, as in LAMMPS, which bounds the sum by 0, not its terms. "
          "LAMMPS reads the critical twisting moment before the bending one; its documentation before "
          "4Jul2026 lists them the other way round.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
