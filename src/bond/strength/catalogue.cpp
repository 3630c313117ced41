#include <fmt/format.h>

#include <cmath>

#include "bond/parameters.hpp"
#include "bond/strength/criteria.hpp"

namespace bondstatic {

Index StrengthCriterion::find(const std::string& parameter) const {
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (parameters[p].name == parameter) return Index(p);
  return -1;
}

const std::vector<StrengthCriterion>& strength_criteria() {
  static const std::vector<StrengthCriterion> criteria{edem_v2_strength(),        pfc_parallel_strength(),
                                                       brown_strength(),          musen_strength(),
                                                       bpm_rotational_strength(), contact_bond_strength()};
  return criteria;
}

const StrengthCriterion* find_strength_criterion(const std::string& name) {
  for (const StrengthCriterion& criterion : strength_criteria())
    if (criterion.name == name) return &criterion;
  return nullptr;
}

std::vector<double> complete_strengths(const StrengthCriterion& criterion, std::vector<double> given,
                                       std::vector<std::string>& complaints) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  if (given.size() > criterion.parameters.size())
    complaints.push_back(fmt::format("{} strengths given, but {} takes {}", given.size(), criterion.name,
                                     criterion.parameters.size()));
  given.resize(criterion.parameters.size(), not_given);
  for (std::size_t p = 0; p < given.size(); ++p) {
    if (criterion.scatters[p] && given[p] == unlimited) continue;
    complete_alone(criterion.parameters[p], given[p], complaints);
    if (std::isnan(given[p]) && criterion.parameters[p].optional) given[p] = unlimited;
  }
  return given;
}

}  // namespace bondstatic
