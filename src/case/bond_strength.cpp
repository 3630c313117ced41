#include "case/bond_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "case/bond_parameters.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

using Scatter = BondStrength::Scatter;

/// How strengths scatter, and what the number that says how much is called.
struct Way {
  Scatter scatter;
  std::string name, number;
};

const std::array<Way, 3>& ways() {
  static const std::array<Way, 3> all{{{Scatter::weibull, "weibull", "modulus"},
                                       {Scatter::normal, "normal", "variation"},
                                       {Scatter::uniform, "uniform", "range"}}};
  return all;
}

/// What can scatter, by position.
std::vector<std::size_t> scattering(const StrengthCriterion& criterion) {
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < criterion.parameters.size(); ++p)
    if (criterion.scatters[p]) out.push_back(p);
  return out;
}

Dimension dimension_of(const Way& way, const Parameter& strength) {
  return way.scatter == Scatter::uniform ? strength.dimension : dimension::none;
}

/// One number for all, which needs one dimension.
void read_common_spread(TableReader& table, const Way& way, const StrengthCriterion& criterion,
                        BondStrength& made) {
  const std::vector<std::size_t> all = scattering(criterion);
  const Dimension dimension = dimension_of(way, criterion.parameters[all.front()]);
  std::vector<std::string> names;
  for (const std::size_t p : all) names.push_back(criterion.parameters[p].name);
  for (const std::size_t p : all)
    if (!(dimension_of(way, criterion.parameters[p]) == dimension))
      return table.reading().fault(
          table.place_of(way.number),
          fmt::format("one {} for strengths that are not of one dimension: {}", way.number, name_list(names)),
          fmt::format("write {} = {{ {} = .., {} = .. }}", way.number, names.front(), names.back()));
  const auto spread = table.number(way.number, dimension, Allowed::positive);
  for (const std::size_t p : all) made.spread[p] = spread.value_or(0);
}

void read_spread(TableReader& table, const Way& way, const StrengthCriterion& criterion, BondStrength& made) {
  if (!table.require(way.number,
                     fmt::format("add {} = .., one number for all strengths or a table", way.number)))
    return;
  Node& node = *table.find(way.number);
  if (!node.is_table()) return read_common_spread(table, way, criterion, made);
  TableReader by_name(table.reading(), node, way.number);
  for (const std::size_t p : scattering(criterion)) {
    const Parameter& strength = criterion.parameters[p];
    made.spread[p] =
        by_name.number(strength.name, dimension_of(way, strength), Allowed::not_negative).value_or(0);
  }
  if (node.items.empty())
    table.reading().fault(node.place, way.number + " is empty",
                          "name a strength, or give one number for all");
  by_name.finish();
}

/// A range that reaches below zero is another distribution than the one that was asked for.
void check_ranges(TableReader& table, const StrengthCriterion& criterion, const BondStrength& made) {
  for (const std::size_t p : scattering(criterion)) {
    if (!(made.parameters[p] > 0) || !(made.spread[p] > made.parameters[p])) continue;
    Node& range = *table.find("range");
    const Node* own = range.find(criterion.parameters[p].name);
    table.reading().fault((own ? *own : range).place,
                          fmt::format("range = {} must be at most {} = {}", made.spread[p],
                                      criterion.parameters[p].name, made.parameters[p]),
                          "strengths are positive: narrow the range");
  }
}

void read_scatter(TableReader& table, const StrengthCriterion& criterion, BondStrength& made) {
  std::vector<std::string> names{"none"};
  for (const Way& way : ways()) names.push_back(way.name);
  const bool named = table.has("scatter");
  const std::string name = table.choice_or("scatter", "none", names);
  const auto chosen =
      std::find_if(ways().begin(), ways().end(), [&](const Way& way) { return way.name == name; });
  for (const Way& way : ways()) {
    if (!table.has(way.number) || (chosen != ways().end() && way.number == chosen->number)) continue;
    if (chosen != ways().end())
      table.reading().fault(
          table.place_of(way.number), fmt::format("{} does not go with scatter = \"{}\"", way.number, name),
          fmt::format("it takes {}; scatter = \"{}\" takes {}", chosen->number, way.name, way.number));
    else if (!named)
      table.reading().fault(table.place_of(way.number),
                            fmt::format("{}, but the strengths do not scatter", way.number),
                            fmt::format("add scatter = \"{}\"", way.name));
  }
  made.spread.assign(criterion.parameters.size(), 0);
  if (chosen == ways().end()) {
    for (const char* key : {"seed", "together"})
      if (table.has(key) && !named)
        table.reading().fault(table.place_of(key), fmt::format("{}, but the strengths do not scatter", key),
                              "add scatter = \"weibull\", \"normal\" or \"uniform\", or remove it");
    return;
  }
  made.scatter = chosen->scatter;
  read_spread(table, *chosen, criterion, made);
  if (made.scatter == Scatter::uniform) check_ranges(table, criterion, made);
  made.seed = table.whole_or("seed", 1, 0);
  made.together = table.truth_or("together", false);
}

/// The parameter that alone gives bonds of a law a section, where it is left open; -1: they have one anyway.
Index section_parameter(const BondLaw& law) {
  const Index radius = law.find("radius");
  if (radius < 0 || !law.parameters[std::size_t(radius)].optional) return -1;
  for (const Alternatives& ways : law.alternatives)
    for (const auto& way : ways)
      if (std::find(way.begin(), way.end(), "radius") != way.end()) return -1;
  return radius;
}

/// Of a block that gives no radius.
void need_section(TableReader& block, const StrengthCriterion& criterion, const BondLaw& law,
                  std::size_t radius, const BondRows* rows) {
  constexpr int most_faults = 20;
  std::vector<std::string> of_forces;
  for (const StrengthCriterion& each : strength_criteria())
    if (!each.needs_section) of_forces.push_back(each.name);
  const std::string cure =
      fmt::format("give radius, or choose a criterion of forces: {}", name_list(of_forces));
  if (!rows || !rows->overrides.contains(radius))
    return block.reading().fault(
        block.find("strength")->find("criterion")->place,
        fmt::format("criterion {} speaks of stresses, but bonds of law {} have no section", criterion.name,
                    law.name),
        cure);
  const std::vector<double>& own = rows->overrides.at(radius);
  int faulty = 0;
  for (std::size_t row = 0; row < own.size() && faulty < most_faults; ++row)
    if (std::isnan(own[row])) {
      ++faulty;
      block.reading().fault(
          rows->places[row],
          fmt::format("the bond has no radius, but criterion {} speaks of stresses", criterion.name), cure);
    }
}

}  // namespace

std::optional<GivenStrengths> read_strength(TableReader& block) {
  Node* node = block.find("strength");
  if (!node) return std::nullopt;
  const std::size_t before = block.reading().faults.size();
  TableReader table(block.reading(), *node, "strength");
  if (!node->is_table()) return std::nullopt;
  std::vector<std::string> names;
  for (const StrengthCriterion& criterion : strength_criteria()) names.push_back(criterion.name);
  const StrengthCriterion* criterion = find_strength_criterion(
      read_one_of(table, "criterion", names, "; `bondstatic laws --strengths` explains them"));
  if (!criterion) return std::nullopt;
  GivenStrengths strengths{criterion, {}};
  strengths.made.criterion = criterion->name;
  strengths.made.parameters = read_parameters(table, *criterion);
  read_scatter(table, *criterion, strengths.made);
  table.finish();
  if (block.reading().faults.size() != before) return std::nullopt;
  return strengths;
}

void check_strength(TableReader& block, GivenStrengths& strengths, const BondLaw& law,
                    const std::vector<double>& given, const BondRows* rows) {
  const StrengthCriterion& criterion = *strengths.criterion;
  if (!rows || rows->strengths.empty()) {
    TableReader table(block.reading(), *block.find("strength"), "strength");
    std::vector<double>& values = strengths.made.parameters;
    values = complete_parameters(table, criterion, values);
    // What is left out stays so: a case has no infinite strength.
    std::replace_if(
        values.begin(), values.end(), [](double v) { return std::isinf(v); }, not_given);
  }
  const Index radius = section_parameter(law);
  if (criterion.needs_section && radius >= 0 && std::isnan(given[std::size_t(radius)]))
    need_section(block, criterion, law, std::size_t(radius), rows);
}

}  // namespace bondstatic
