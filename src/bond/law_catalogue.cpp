#include "bond/laws/laws.hpp"

namespace bondstatic {

const std::vector<BondLaw>& bond_laws() {
  static const std::vector<BondLaw> laws{
      parallel_law(), pfc_parallel_law(), euler_bernoulli_law(), timoshenko_law(),  obermayr_law(),
      edem_v2_law(),  contact_law(),      two_segment_law(),     concave_end_law(), generic_law(),
  };
  return laws;
}

const BondLaw* find_bond_law(const std::string& name) {
  for (const BondLaw& law : bond_laws())
    if (law.name == name) return &law;
  return nullptr;
}

}  // namespace bondstatic
