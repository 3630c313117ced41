#include "case/bond_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/nearest_name.hpp"

namespace bondstatic {

std::string read_one_of(TableReader& table, const std::string& key, const std::vector<std::string>& names,
                        const std::string& more) {
  if (!table.require(key, fmt::format("add {} = \"..\", one of: {}", key, name_list(names)))) return {};
  const auto name = table.text(key);
  if (!name) return {};
  if (std::find(names.begin(), names.end(), *name) != names.end()) return *name;
  const std::string nearest = nearest_name(*name, names);
  table.reading().fault(
      table.place_of(key), fmt::format("{} = \"{}\" is unknown; there are: {}", key, *name, name_list(names)),
      nearest.empty() ? "choose one of them" + more : fmt::format("did you mean \"{}\"?", nearest));
  return {};
}

const BondLaw* read_law(TableReader& block, const std::string& otherwise) {
  if (!otherwise.empty()) block.set_default("law", Node::of(otherwise));
  std::vector<std::string> names;
  for (const BondLaw& law : bond_laws()) names.push_back(law.name);
  return find_bond_law(read_one_of(block, "law", names, "; `bondstatic laws` explains them"));
}

std::vector<double> read_parameters(TableReader& table, const ParameterList& list) {
  std::vector<double> given;
  for (const Parameter& parameter : *list.parameters) {
    std::optional<double> value;
    if (parameter.truth) {
      if (const Node* node = table.find(parameter.name))
        if (const auto truth = read_truth(table.reading(), *node, parameter.name)) value = *truth ? 1 : 0;
    } else if (parameter.whole) {
      if (const auto whole = table.whole(parameter.name, Index(parameter.lower))) value = double(*whole);
    } else {
      value = table.number(parameter.name, parameter.dimension);
    }
    given.push_back(value.value_or(not_given));
  }
  return given;
}

Complaint explain(const ParameterList& list, const std::string& complaint) {
  const std::string name = complaint.substr(0, complaint.find_first_of(" ="));
  const Index found = list.find(name);
  if (found < 0) return {"", complaint, list.more};
  const Parameter& parameter = (*list.parameters)[std::size_t(found)];
  const std::string unit = si_unit(parameter.dimension);
  return {
      name, complaint,
      fmt::format("{} is {}{}; {}", name, parameter.meaning,
                  unit.empty() ? "" : fmt::format(", in {} or another consistent unit", unit), list.more)};
}

std::vector<double> complete_parameters(TableReader& table, const ParameterList& list,
                                        const std::vector<double>& given) {
  std::vector<std::string> complaints;
  std::vector<double> completed = given;
  list.complete(completed, complaints);
  for (const std::string& text : complaints) {
    const Complaint complaint = explain(list, text);
    const Place& place = complaint.parameter.empty() ? table.place() : table.place_of(complaint.parameter);
    table.reading().fault(place, complaint.message, complaint.cure);
  }
  for (std::size_t p = 0; p < given.size() && complaints.empty(); ++p) {
    const Parameter& parameter = (*list.parameters)[p];
    // An optional strength that is not given is infinite: it has no default to show.
    if (!std::isnan(given[p]) || !std::isfinite(completed[p])) continue;
    table.set_default(parameter.name, parameter.truth   ? Node::of(completed[p] != 0)
                                      : parameter.whole ? Node::of(Index(completed[p]))
                                                        : Node::of(completed[p]));
  }
  return completed;
}

}  // namespace bondstatic
