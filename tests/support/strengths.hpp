// Strengths for models built in code.
#pragma once

#include <stdexcept>

#include "bondstatic/strength.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

/// Of one criterion, without scatter.
inline BondStrength strength(const std::string& criterion, const Values& values) {
  const StrengthCriterion* found = find_strength_criterion(criterion);
  if (!found) throw std::logic_error("no criterion " + criterion);
  BondStrength made{criterion, std::vector<double>(found->parameters.size(), not_given)};
  for (const auto& [name, value] : values) made.parameters.at(std::size_t(found->find(name))) = value;
  return made;
}

}  // namespace bondstatic::test
