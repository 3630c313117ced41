#include "case/bond_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/table/column_names.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

/// Positions of the particles that a column names by id.
std::vector<Index> read_ends(Draft& draft, const Table& table, int column) {
  std::vector<Index> ends = table.whole_numbers(column, draft.reading.faults);
  int unknown = 0;
  for (std::size_t row = 0; row < ends.size() && draft.particles_known; ++row) {
    if (const Index* found = draft.particle_of_id.position_of(ends[row]))
      ends[row] = *found;
    else if (++unknown <= most_faults)
      draft.reading.fault(table.place(Index(row), column), fmt::format("there is no particle {}", ends[row]),
                          "columns a and b hold particle ids");
  }
  return ends;
}

using ColumnOf = std::map<std::size_t, int>;  // by parameter

struct ParameterColumns {
  ColumnOf of_law, of_strength;
};

ParameterColumns parameter_columns(Draft& draft, const Table& table, const BondLaw& law,
                                   const StrengthCriterion* criterion, const std::vector<int>& used) {
  ParameterColumns columns;
  std::string owners = "law " + law.name;
  std::vector<std::string> unused, parameters = ParameterList(law).names();
  if (criterion) {
    owners += " or criterion " + criterion->name;
    for (const Parameter& strength : criterion->parameters) parameters.push_back(strength.name);
  }
  for (std::size_t c = 0; c < table.names().size(); ++c) {
    const std::string& name = table.names()[c];
    if (std::find(used.begin(), used.end(), int(c)) != used.end()) continue;
    const Index parameter = law.find(name), strength = criterion ? criterion->find(name) : -1;
    const bool stiffness =
        std::find(stiffness_names.begin(), stiffness_names.end(), name) != stiffness_names.end();
    const std::string nearest = name.size() < 4 ? "" : nearest_name(name, parameters);
    if (parameter >= 0) columns.of_law[std::size_t(parameter)] = int(c);
    if (strength >= 0) columns.of_strength[std::size_t(strength)] = int(c);
    if (parameter >= 0 || strength >= 0) continue;
    if (stiffness || !nearest.empty())
      draft.reading.fault(table.place(-1, int(c)),
                          fmt::format("column \"{}\" is no parameter of {}; there are: {}", name, owners,
                                      name_list(parameters)),
                          stiffness ? "use law = \"generic\" for given stiffnesses"
                                    : fmt::format("did you mean \"{}\"?", nearest));
    else
      unused.push_back(name);
  }
  if (!unused.empty())
    draft.reading.warnings.push_back(
        fmt::format("{}: columns not used: {}", table.place(-1, -1).file, name_list(unused)));
  return columns;
}

}  // namespace

bool has_bond_ends(const Table& table) {
  std::vector<Fault> unsaid;
  return table.find(own_columns::bond_a, unsaid) >= 0 && table.find(own_columns::bond_b, unsaid) >= 0;
}

std::optional<BondRows> rows_of_bond_table(Draft& draft, const Table& table, const BondLaw& law,
                                           const std::vector<double>& given,
                                           const GivenStrengths* strengths) {
  std::vector<Fault>& faults = draft.reading.faults;
  const std::size_t before = faults.size();
  const int id = table.find(own_columns::bond_id, faults), a = table.find(own_columns::bond_a, faults),
            b = table.find(own_columns::bond_b, faults);
  const int point = table.find(own_columns::contact_point, faults);
  if (a < 0 || b < 0)
    faults.push_back({table.place(-1, -1),
                      fmt::format("no column {}; found: {}", a < 0 ? "a" : "b", name_list(table.names())),
                      "columns a and b hold the ids of the particles that a bond joins"});
  const ParameterColumns columns =
      parameter_columns(draft, table, law, strengths ? strengths->criterion : nullptr, {id, a, b, point});
  if (faults.size() != before) return std::nullopt;

  BondRows rows;
  rows.a = read_ends(draft, table, a);
  rows.b = read_ends(draft, table, b);
  if (id >= 0) rows.ids = table.whole_numbers(id, faults);
  if (point >= 0) rows.fractions = table.numbers(point, true, faults);
  for (const auto& [parameter, column] : columns.of_law)
    rows.overrides[parameter] = table.numbers(column, true, faults);
  for (const auto& [strength, column] : columns.of_strength)
    rows.strengths[strength] = table.numbers(column, true, faults);
  rows.places = RowPlaces(table, 0);
  if (faults.size() == before) {
    const auto place_in = [&](const ColumnOf& of) {
      return [&](Index row, Index parameter) {
        const auto column = of.find(std::size_t(parameter));
        return table.place(row, column == of.end() ? 0 : column->second);
      };
    };
    check_bond_parameters(draft, law, given, rows, place_in(columns.of_law));
    check_bond_strengths(draft, strengths, rows, place_in(columns.of_strength));
    check_fractions(draft, rows, [&](Index row) { return table.place(row, point); });
  }
  return rows;
}

}  // namespace bondstatic
