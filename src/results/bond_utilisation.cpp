#include "results/bond_utilisation.hpp"

#include "bondstatic/bond_law.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

std::vector<double> bond_utilisations(const Model& model, const State& state,
                                      const std::vector<Index>& break_event) {
  const std::vector<BondProperties> properties = bond_properties(model);
  const BondFailures failures = bond_failures(model, properties);
  std::vector<double> values(model.bonds.size(), not_given);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto modes = failures.of(Index(k));
    const Vector6 q = -state.bonds[k].force;
    if (break_event[k] >= 0 || modes.empty() || q.hasNaN()) continue;
    const Vector3& branch = model.bonds[k].branch;
    values[k] = utilisation(modes, branch.norm(), properties[k].fraction, section_vector(branch, q)).value;
  }
  return values;
}

}  // namespace bondstatic
