#include "case/bond_parameters.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/nearest_name.hpp"

namespace bondstatic {

const BondLaw* read_law(TableReader& block, const std::string& otherwise) {
  if (!otherwise.empty()) block.set_default("law", Node::of(otherwise));
  std::vector<std::string> names;
  for (const BondLaw& law : bond_laws()) names.push_back(law.name);
  if (!block.require("law", fmt::format("add law = \"..\", one of: {}", name_list(names)))) return nullptr;
  const auto name = block.text("law");
  if (!name) return nullptr;
  if (const BondLaw* law = find_bond_law(*name)) return law;
  const std::string nearest = nearest_name(*name, names);
  block.reading().fault(block.place_of("law"),
                        fmt::format("law = \"{}\" is unknown; there are: {}", *name, name_list(names)),
                        nearest.empty() ? "choose one of them; `bondstatic laws` explains them"
                                        : fmt::format("did you mean \"{}\"?", nearest));
  return nullptr;
}

std::vector<double> read_parameters(TableReader& block, const BondLaw& law) {
  std::vector<double> given;
  for (const Parameter& parameter : law.parameters) {
    std::optional<double> value;
    if (parameter.truth) {
      if (const Node* node = block.find(parameter.name))
        if (const auto truth = read_truth(block.reading(), *node, parameter.name)) value = *truth ? 1 : 0;
    } else if (parameter.whole) {
      if (const auto whole = block.whole(parameter.name, Index(parameter.lower))) value = double(*whole);
    } else {
      value = block.number(parameter.name, parameter.dimension);
    }
    given.push_back(value.value_or(not_given));
  }
  return given;
}

Complaint explain(const BondLaw& law, const std::string& complaint) {
  const std::string name = complaint.substr(0, complaint.find_first_of(" ="));
  const Index found = law.find(name);
  if (found < 0) return {"", complaint, "see `bondstatic laws " + law.name + "`"};
  const Parameter& parameter = law.parameters[std::size_t(found)];
  const std::string unit = si_unit(parameter.dimension);
  return {name, complaint,
          fmt::format("{} is {}{}; see `bondstatic laws {}`", name, parameter.meaning,
                      unit.empty() ? "" : fmt::format(", in {} or another consistent unit", unit), law.name)};
}

std::vector<double> complete_parameters(TableReader& block, const BondLaw& law,
                                        const std::vector<double>& given) {
  std::vector<std::string> complaints;
  const std::vector<double> completed = complete_parameters(law, given, complaints);
  for (const std::string& text : complaints) {
    const Complaint complaint = explain(law, text);
    const Place& place = complaint.parameter.empty() ? block.place() : block.place_of(complaint.parameter);
    block.reading().fault(place, complaint.message, complaint.cure);
  }
  for (std::size_t p = 0; p < law.parameters.size() && complaints.empty(); ++p) {
    const Parameter& parameter = law.parameters[p];
    if (!std::isnan(given[p]) || std::isnan(completed[p])) continue;
    block.set_default(parameter.name, parameter.truth   ? Node::of(completed[p] != 0)
                                      : parameter.whole ? Node::of(Index(completed[p]))
                                                        : Node::of(completed[p]));
  }
  return completed;
}

}  // namespace bondstatic
