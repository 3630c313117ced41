// Completing parameters: bounds and defaults of each, and those of a law together, for many bonds (names are
// resolved once).
#pragma once

#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

/// Complains where the value is out of the parameter's bounds, or infinite.
void check_bounds(const Parameter& parameter, double value, std::vector<std::string>& complaints);

/// A parameter that no other can stand for: fills in its default, complains where it is missing or out of
/// bounds.
void complete_alone(const Parameter& parameter, double& value, std::vector<std::string>& complaints);

/// A law's alternatives as positions in its parameter list: alternatives > ways > parameters.
struct ParameterRules {
  const BondLaw* law = nullptr;
  std::vector<std::vector<std::vector<std::size_t>>> alternatives;
  std::vector<bool> in_alternative;  ///< by parameter

  /// Parameters that a value for parameter `given` rules out: those of the other ways to say the same thing.
  std::vector<std::size_t> ruled_out_by(std::size_t given) const;
};

ParameterRules parameter_rules(const BondLaw& law);

/// As complete_parameters(), in place; `values` has the size of the law's list. True if there was no
/// complaint.
bool complete(const ParameterRules& rules, std::vector<double>& values, std::vector<std::string>& complaints);

}  // namespace bondstatic
