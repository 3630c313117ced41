#include "case/bond_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bond/parameters.hpp"
#include "case/bond_parameters.hpp"
#include "io/nearest_name.hpp"
#include "io/table.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

using Names = std::vector<std::string>;

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

/// Columns that belong to the law, by parameter. Others are named in a warning, or are faults where they look
/// like a slip.
std::map<std::size_t, int> parameter_columns(Draft& draft, const Table& table, const BondLaw& law,
                                             const std::vector<int>& used) {
  std::map<std::size_t, int> columns;
  Names unused, parameters;
  for (const Parameter& parameter : law.parameters) parameters.push_back(parameter.name);
  for (std::size_t c = 0; c < table.names().size(); ++c) {
    const std::string& name = table.names()[c];
    if (std::find(used.begin(), used.end(), int(c)) != used.end()) continue;
    const Index parameter = law.find(name);
    const bool stiffness = name == "kn" || name == "ks" || name == "kt" || name == "kb";
    const std::string nearest = name.size() < 4 ? "" : nearest_name(name, parameters);
    if (parameter >= 0)
      columns[std::size_t(parameter)] = int(c);
    else if (stiffness || !nearest.empty())
      draft.reading.fault(table.place(-1, int(c)),
                          fmt::format("column \"{}\" is no parameter of law {}; it has: {}", name, law.name,
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

/// Each bond's parameters as the law will see them: what a row gives rules out other ways to say the same
/// thing in the block (`radius` a `radius_factor`).
void check_rows(Draft& draft, const Table& table, const BondLaw& law, const std::vector<double>& given,
                const std::map<std::size_t, int>& columns, const BondRows& rows) {
  const ParameterRules rules = parameter_rules(law);
  std::map<std::size_t, std::vector<std::size_t>> ruled_out;
  for (const auto& column : columns) ruled_out[column.first] = rules.ruled_out_by(column.first);
  int faulty = 0;
  for (Index row = 0; row < table.rows() && faulty < most_faults; ++row) {
    std::vector<double> values = given;
    values.resize(law.parameters.size(), not_given);
    const auto own = [&](std::size_t p) { return rows.overrides.at(p)[std::size_t(row)]; };
    for (const auto& column : columns)
      if (!std::isnan(own(column.first)))
        for (const std::size_t p : ruled_out.at(column.first)) values[p] = not_given;
    for (const auto& [p, column] : columns)
      if (!std::isnan(own(p))) values[p] = own(p);
    std::vector<std::string> complaints;
    complete(rules, values, complaints);
    for (const std::string& text : complaints) {
      const Complaint complaint = explain(law, text);
      const auto column = columns.find(std::size_t(law.find(complaint.parameter)));
      draft.reading.fault(table.place(row, column == columns.end() ? 0 : column->second), complaint.message,
                          complaint.cure);
    }
    faulty += !complaints.empty();
    if (columns.empty() && complaints.empty()) return;  // all rows are alike
  }
}

}  // namespace

std::optional<BondRows> read_bond_file(Draft& draft, TableReader& block, const BondLaw& law,
                                       const std::vector<double>& given) {
  std::vector<Fault>& faults = draft.reading.faults;
  const std::size_t before = faults.size();
  const auto path = block.path("file");
  if (!path) return std::nullopt;
  const auto table = read_table(*path, block.place_of("file"), faults, draft.reading.threads);
  if (!table) return std::nullopt;
  const int id = table->find(Names{"id", "bond_id"}, faults);
  const int a = table->find(Names{"a", "id_a", "id1", "particle_a"}, faults);
  const int b = table->find(Names{"b", "id_b", "id2", "particle_b"}, faults);
  if (a < 0 || b < 0)
    faults.push_back({table->place(-1, -1),
                      fmt::format("no column {}; found: {}", a < 0 ? "a" : "b", name_list(table->names())),
                      "columns a and b hold the ids of the particles that a bond joins"});
  const std::map<std::size_t, int> columns = parameter_columns(draft, *table, law, {id, a, b});
  if (faults.size() != before) return std::nullopt;

  BondRows rows;
  rows.a = read_ends(draft, *table, a);
  rows.b = read_ends(draft, *table, b);
  if (id >= 0) rows.ids = table->whole_numbers(id, faults);
  for (const auto& [parameter, column] : columns)
    rows.overrides[parameter] = table->numbers(column, true, faults);
  rows.places = RowPlaces(*table, 0);
  if (faults.size() == before) check_rows(draft, *table, law, given, columns, rows);
  for (std::size_t row = 0; row < rows.a.size() && faults.size() == before; ++row)
    if (rows.a[row] == rows.b[row])
      faults.push_back({rows.places[row], "the bond joins a particle to itself", "give two different ids"});
  if (faults.size() != before) return std::nullopt;
  return rows;
}

}  // namespace bondstatic
