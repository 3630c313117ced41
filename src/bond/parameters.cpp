#include "bond/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bondstatic {
namespace {

using Way = std::vector<std::size_t>;

std::string allowed(const Parameter& parameter) {
  const bool bounded = std::isfinite(parameter.upper);
  if (parameter.truth) return "must be true or false";
  if (parameter.lower == 0 && !bounded)
    return parameter.lower_included ? "must not be negative" : "must be positive";
  std::string text =
      fmt::format("must be {} {}", parameter.lower_included ? "at least" : "greater than", parameter.lower);
  if (bounded) text += fmt::format(" and at most {}", parameter.upper);
  return text;
}

std::string names(const BondLaw& law, const Way& way) {
  std::string text;
  for (const std::size_t p : way) text += (text.empty() ? "" : " and ") + law.parameters[p].name;
  return text;
}

std::string names(const BondLaw& law, const std::vector<Way>& ways) {
  std::string text;
  for (const Way& way : ways) text += (text.empty() ? "" : ", or ") + names(law, way);
  return text;
}

/// Fills in the way that was chosen, or the first that needs no choice; complains where there is not exactly
/// one.
void complete_alternative(const BondLaw& law, const std::vector<Way>& ways, std::vector<double>& values,
                          std::vector<std::string>& complaints) {
  const auto given = [&](std::size_t p) { return !std::isnan(values[p]); };
  const auto has_default = [&](std::size_t p) { return !std::isnan(law.parameters[p].default_value); };
  const Way* chosen = nullptr;
  for (const Way& way : ways) {
    const auto first = std::find_if(way.begin(), way.end(), given);
    if (first == way.end()) continue;
    if (chosen) {
      const auto other = std::find_if(chosen->begin(), chosen->end(), given);
      complaints.push_back(fmt::format("{} and {} exclude each other: give either {}",
                                       law.parameters[*other].name, law.parameters[*first].name,
                                       names(law, ways)));
      return;
    }
    chosen = &way;
  }
  if (!chosen) {
    for (const Way& way : ways)
      if (!chosen && std::all_of(way.begin(), way.end(), has_default)) chosen = &way;
    if (!chosen) {
      complaints.push_back(fmt::format("{} missing: give {}", names(law, ways.front()), names(law, ways)));
      return;
    }
  }
  for (const std::size_t p : *chosen) {
    if (given(p)) continue;
    if (has_default(p))
      values[p] = law.parameters[p].default_value;
    else
      complaints.push_back(
          fmt::format("{} missing: give {} together", law.parameters[p].name, names(law, *chosen)));
  }
}

}  // namespace

void check_bounds(const Parameter& parameter, double value, std::vector<std::string>& complaints) {
  const bool above = parameter.lower_included ? value >= parameter.lower : value > parameter.lower;
  if (std::isinf(value))
    complaints.push_back(fmt::format("{} = {}: must be finite", parameter.name, value));
  else if (!above || value > parameter.upper)
    complaints.push_back(fmt::format("{} = {}: {}", parameter.name, value, allowed(parameter)));
  else if (parameter.whole && value != std::floor(value))
    complaints.push_back(fmt::format("{} = {}: must be a whole number", parameter.name, value));
}

void complete_alone(const Parameter& parameter, double& value, std::vector<std::string>& complaints) {
  if (std::isnan(value) && !parameter.optional) {
    value = parameter.default_value;
    if (std::isnan(value))
      complaints.push_back(fmt::format("{} missing: give the {}", parameter.name, parameter.meaning));
  }
  if (!std::isnan(value)) check_bounds(parameter, value, complaints);
}

std::vector<std::size_t> ParameterRules::ruled_out_by(std::size_t given) const {
  std::vector<std::size_t> out;
  for (const std::vector<Way>& ways : alternatives) {
    const auto has_it = [&](const Way& way) { return std::find(way.begin(), way.end(), given) != way.end(); };
    if (std::none_of(ways.begin(), ways.end(), has_it)) continue;
    for (const Way& way : ways)
      if (!has_it(way)) out.insert(out.end(), way.begin(), way.end());
  }
  return out;
}

ParameterRules parameter_rules(const BondLaw& law) {
  ParameterRules rules;
  rules.law = &law;
  rules.in_alternative.resize(law.parameters.size());
  for (const Alternatives& alternative : law.alternatives) {
    std::vector<Way>& ways = rules.alternatives.emplace_back();
    for (const std::vector<std::string>& group : alternative) {
      Way& way = ways.emplace_back();
      for (const std::string& name : group) {
        way.push_back(std::size_t(law.find(name)));
        rules.in_alternative.at(way.back()) = true;
      }
    }
  }
  return rules;
}

bool complete(const ParameterRules& rules, std::vector<double>& values,
              std::vector<std::string>& complaints) {
  const BondLaw& law = *rules.law;
  const std::size_t before = complaints.size();
  for (const std::vector<Way>& ways : rules.alternatives) complete_alternative(law, ways, values, complaints);
  for (std::size_t p = 0; p < law.parameters.size(); ++p) {
    if (!rules.in_alternative[p])
      complete_alone(law.parameters[p], values[p], complaints);
    else if (!std::isnan(values[p]))
      check_bounds(law.parameters[p], values[p], complaints);
  }
  // Only what stands on its own can be compared with each other.
  if (complaints.size() == before && law.inconsistent)
    if (std::string clash = law.inconsistent(values); !clash.empty()) complaints.push_back(std::move(clash));
  return complaints.size() == before;
}

Index BondLaw::find(const std::string& parameter) const {
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (parameters[p].name == parameter) return Index(p);
  return -1;
}

std::vector<double> complete_parameters(const BondLaw& law, std::vector<double> given,
                                        std::vector<std::string>& complaints) {
  if (given.size() > law.parameters.size())
    complaints.push_back(
        fmt::format("{} parameters given, but {} takes {}", given.size(), law.name, law.parameters.size()));
  given.resize(law.parameters.size(), not_given);
  complete(parameter_rules(law), given, complaints);
  return given;
}

}  // namespace bondstatic
