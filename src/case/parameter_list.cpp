#include "case/parameter_list.hpp"

#include <fmt/format.h>

#include "bond/parameters.hpp"

namespace bondstatic {

ParameterList::ParameterList(const BondLaw& law)
    : more(fmt::format("see `bondstatic laws {}`", law.name)), parameters(&law.parameters) {
  const ParameterRules rules = parameter_rules(law);
  complete = [rules](std::vector<double>& values, std::vector<std::string>& complaints) {
    return bondstatic::complete(rules, values, complaints);
  };
  ruled_out_by = [rules](std::size_t given) { return rules.ruled_out_by(given); };
}

ParameterList::ParameterList(const StrengthCriterion& criterion)
    : more(fmt::format("see `bondstatic laws --strengths {}`", criterion.name)),
      parameters(&criterion.parameters) {
  complete = [&criterion](std::vector<double>& values, std::vector<std::string>& complaints) {
    const std::size_t before = complaints.size();
    values = complete_strengths(criterion, std::move(values), complaints);
    return complaints.size() == before;
  };
  ruled_out_by = [](std::size_t) { return std::vector<std::size_t>(); };
}

Index ParameterList::find(const std::string& name) const {
  for (std::size_t p = 0; p < parameters->size(); ++p)
    if ((*parameters)[p].name == name) return Index(p);
  return -1;
}

std::vector<std::string> ParameterList::names() const {
  std::vector<std::string> out;
  for (const Parameter& parameter : *parameters) out.push_back(parameter.name);
  return out;
}

}  // namespace bondstatic
