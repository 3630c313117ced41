#include "bond/codes.hpp"

#include "bond/codes/codes.hpp"

namespace bondstatic {

const std::vector<BondCode>& bond_codes() {
  static const std::vector<BondCode> codes{
      pfc_linearpbond(),    edem_bonding_v2(), lammps_bpm_rotational(),
      liggghts_bond_gran(), yade_cohfrict(),   musen_solid_bond(),
  };
  return codes;
}

const BondCode* find_bond_code(const std::string& name) {
  for (const BondCode& code : bond_codes())
    if (code.name == name) return &code;
  return nullptr;
}

}  // namespace bondstatic
