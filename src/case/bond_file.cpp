#include "case/bond_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bond/parameters.hpp"
#include "case/bond_parameters.hpp"
#include "case/foreign_file.hpp"
#include "io/nearest_name.hpp"
#include "model/cell.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

using Names = std::vector<std::string>;

const Names& id_names() {
  static const Names names{"id", "bond_id"};
  return names;
}
const Names& a_names() {
  static const Names names{"a", "id_a", "id1", "particle_a"};
  return names;
}
const Names& b_names() {
  static const Names names{"b", "id_b", "id2", "particle_b"};
  return names;
}

bool is_stiffness(const std::string& name) {
  return name == "kn" || name == "ks" || name == "kt" || name == "kb";
}

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
    const bool stiffness = is_stiffness(name);
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

/// Where what a parameter's column says of a row stands; the row itself where it has no such column.
using PlaceOf = std::function<Place(Index row, Index parameter)>;

/// Each bond's parameters as the law will see them: what a row gives rules out other ways to say the same
/// thing in the block (`radius` a `radius_factor`).
void check_rows(Draft& draft, const BondLaw& law, const std::vector<double>& given, const BondRows& rows,
                const PlaceOf& place_of) {
  if (rows.overrides.empty()) return;  // all rows are as the block says, which is checked there
  const ParameterRules rules = parameter_rules(law);
  std::map<std::size_t, std::vector<std::size_t>> ruled_out;
  for (const auto& column : rows.overrides) ruled_out[column.first] = rules.ruled_out_by(column.first);
  int faulty = 0;
  for (std::size_t row = 0; row < rows.a.size() && faulty < most_faults; ++row) {
    std::vector<double> values = given;
    values.resize(law.parameters.size(), not_given);
    for (const auto& [p, column] : rows.overrides)
      if (!std::isnan(column[row]))
        for (const std::size_t other : ruled_out.at(p)) values[other] = not_given;
    for (const auto& [p, column] : rows.overrides)
      if (!std::isnan(column[row])) values[p] = column[row];
    std::vector<std::string> complaints;
    complete(rules, values, complaints);
    for (const std::string& text : complaints) {
      const Complaint complaint = explain(law, text);
      draft.reading.fault(place_of(Index(row), law.find(complaint.parameter)), complaint.message,
                          complaint.cure);
    }
    faulty += !complaints.empty();
  }
}

void check_fractions(Draft& draft, const BondRows& rows, const std::function<Place(Index row)>& place_of) {
  int faulty = 0;
  for (std::size_t row = 0; row < rows.fractions.size() && faulty < most_faults; ++row) {
    const double fraction = rows.fractions[row];
    if (std::isnan(fraction) || (fraction > 0 && fraction < 1)) continue;
    ++faulty;
    draft.reading.fault(place_of(Index(row)),
                        fmt::format("contact_point = {} must lie between 0 and 1", fraction),
                        "give the part of the branch from particle a, e.g. 0.5");
  }
}

void check_ends(Draft& draft, const BondRows& rows) {
  int faulty = 0;
  for (std::size_t row = 0; row < rows.a.size() && faulty < most_faults; ++row)
    if (rows.a[row] == rows.b[row]) {
      ++faulty;
      draft.reading.fault(rows.places[row], "the bond joins a particle to itself", "give two different ids");
    }
}

std::optional<BondRows> rows_of(Draft& draft, const Table& table, const BondLaw& law,
                                const std::vector<double>& given) {
  std::vector<Fault>& faults = draft.reading.faults;
  const std::size_t before = faults.size();
  const int id = table.find(id_names(), faults), a = table.find(a_names(), faults),
            b = table.find(b_names(), faults);
  const int point = table.find(Names{"contact_point"}, faults);
  if (a < 0 || b < 0)
    faults.push_back({table.place(-1, -1),
                      fmt::format("no column {}; found: {}", a < 0 ? "a" : "b", name_list(table.names())),
                      "columns a and b hold the ids of the particles that a bond joins"});
  const std::map<std::size_t, int> columns = parameter_columns(draft, table, law, {id, a, b, point});
  if (faults.size() != before) return std::nullopt;

  BondRows rows;
  rows.a = read_ends(draft, table, a);
  rows.b = read_ends(draft, table, b);
  if (id >= 0) rows.ids = table.whole_numbers(id, faults);
  if (point >= 0) rows.fractions = table.numbers(point, true, faults);
  for (const auto& [parameter, column] : columns)
    rows.overrides[parameter] = table.numbers(column, true, faults);
  rows.places = RowPlaces(table, 0);
  if (faults.size() == before) {
    check_rows(draft, law, given, rows, [&](Index row, Index parameter) {
      const auto column = columns.find(std::size_t(parameter));
      return table.place(row, column == columns.end() ? 0 : column->second);
    });
    check_fractions(draft, rows, [&](Index row) { return table.place(row, point); });
  }
  return rows;
}

/// Columns of another code's file that the law takes, as overrides; what becomes of the others is said.
void take_columns(Draft& draft, const std::string& path, ForeignModel& model, const BondLaw& law,
                  BondRows& rows) {
  Names stiffness, unused;
  for (auto& [name, values] : model.bond_columns) {
    const Index parameter = law.find(name);
    if (name == "contact_point")
      rows.fractions = std::move(values);
    else if (parameter >= 0)
      rows.overrides[std::size_t(parameter)] = std::move(values);
    else
      (is_stiffness(name) ? stiffness : unused).push_back(name);
  }
  for (const auto& column : model.kept_columns) unused.push_back(column.first);
  if (!stiffness.empty())
    draft.reading.warnings.push_back(fmt::format("{}: its stiffness ({}) is left out: the block has law {}",
                                                 path, name_list(stiffness), law.name));
  if (!unused.empty())
    draft.reading.warnings.push_back(fmt::format("{}: not used: {}", path, name_list(unused)));
}

/// A bond that a periodic file means to go through a face of its box would go the other way round.
void need_cell(Draft& draft, const ForeignModel& model, const BondRows& rows) {
  if (!model.cell || draft.model.cell || !draft.particles_known) return;
  Index across = 0;
  const std::vector<Particle>& particles = draft.model.particles;
  for (std::size_t k = 0; k < rows.a.size(); ++k) {
    const Vector3 branch =
        particles[std::size_t(rows.b[k])].position - particles[std::size_t(rows.a[k])].position;
    across += nearest_image(*model.cell, branch).image != CellImage{};
  }
  if (across > 0)
    draft.reading.fault(rows.places[0],
                        fmt::format("the file's box is periodic, and {} of its bonds go through its "
                                    "faces, but the case has no [cell]",
                                    across),
                        "add it; `bondstatic import` writes the table");
}

std::optional<BondRows> rows_of(Draft& draft, const std::string& path, ForeignModel model, const BondLaw& law,
                                const std::vector<double>& given) {
  BondRows rows;
  const std::size_t count = model.bonds.size();
  rows.places = RowPlaces(path, model.bond_line, count);
  bool numbered = false;
  int unknown = 0;
  const auto position_of = [&](Index id, std::size_t row) {
    const Index* found = draft.particle_of_id.position_of(id);
    if (!found && draft.particles_known && ++unknown <= most_faults)
      draft.reading.fault(rows.places[row], fmt::format("there is no particle {}", id),
                          "bonds join particles by their ids: read all particles, and these ids, too");
    return found ? *found : -1;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const ForeignBond& bond = model.bonds[k];
    rows.a.push_back(position_of(bond.a, k));
    rows.b.push_back(position_of(bond.b, k));
    rows.ids.push_back(bond.id);
    numbered |= bond.id >= 0;
  }
  if (!numbered) rows.ids.clear();
  if (unknown > 0) return std::nullopt;
  take_columns(draft, path, model, law, rows);
  check_rows(draft, law, given, rows, [&](Index row, Index) { return rows.places[std::size_t(row)]; });
  check_fractions(draft, rows, [&](Index row) { return rows.places[std::size_t(row)]; });
  need_cell(draft, model, rows);
  return rows;
}

}  // namespace

bool BondFile::gives_stiffness() const {
  std::vector<Fault> unsaid;
  for (const char* name : {"kn", "ks", "kt", "kb"})
    if (foreign ? !foreign->bond_columns.count(name) : table->find(Names{name}, unsaid) < 0) return false;
  return true;
}

std::optional<BondFile> open_bond_file(Draft& draft, TableReader& block) {
  std::vector<Fault>& faults = draft.reading.faults;
  const std::size_t before = faults.size();
  const auto path = block.path("file");
  if (!path) return std::nullopt;
  accept_foreign_keys(block, WantedOf::bonds);
  BondFile file{*path, std::nullopt, std::nullopt};
  if (is_foreign_file(*path)) {
    file.foreign = read_foreign_file(block, *path, WantedOf::bonds);
    if (!file.foreign) return std::nullopt;
    if (file.foreign->bonds.empty()) {
      draft.reading.fault(block.place_of("file"), fmt::format("file \"{}\" has no bonds", *path),
                          "let bonds form, by gap or contact_radius_factor, or name the file that has them");
      return std::nullopt;
    }
    return file;
  }
  file.table = read_table(*path, block.place_of("file"), faults, draft.reading.threads);
  std::vector<Fault> unsaid;
  if (file.table && file.table->find(a_names(), unsaid) >= 0 && file.table->find(b_names(), unsaid) >= 0)
    return file;
  // A table without this project's columns may be another code's.
  file.foreign = try_foreign_table(block, *path, WantedOf::bonds, a_names());
  if (!file.foreign) return file.table ? std::optional(std::move(file)) : std::nullopt;
  faults.resize(before);
  return file;
}

std::optional<BondRows> bond_rows(Draft& draft, BondFile file, const BondLaw& law,
                                  const std::vector<double>& given) {
  const std::size_t before = draft.reading.faults.size();
  auto rows = file.foreign ? rows_of(draft, file.path, std::move(*file.foreign), law, given)
                           : rows_of(draft, *file.table, law, given);
  if (rows && draft.reading.faults.size() == before) check_ends(draft, *rows);
  if (draft.reading.faults.size() != before) return std::nullopt;
  return rows;
}

}  // namespace bondstatic
