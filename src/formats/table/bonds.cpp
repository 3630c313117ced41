// Bonds from the columns of a table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bond/codes.hpp"
#include "formats/particle_ids.hpp"
#include "formats/table/column_units.hpp"
#include "formats/table/model.hpp"
#include "io/nearest_name.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

struct KnownColumn {
  const Aliases& aliases;
  Dimension dimension;
};

const std::vector<KnownColumn>& known_columns() {
  static const std::vector<KnownColumn> known{
      {columns::kn, dimension::stiffness},
      {columns::ks, dimension::stiffness},
      {columns::kt, dimension::rotational_stiffness},
      {columns::kb, dimension::rotational_stiffness},
      {columns::bond_radius, dimension::length},
      {columns::bond_diameter, dimension::length},
      {columns::contact_point, dimension::none},
      {columns::normal_stiffness, dimension::stress_per_length},
      {columns::shear_stiffness, dimension::stress_per_length},
  };
  return known;
}

/// What any law calls so; null where none does.
const Parameter* law_parameter(const std::string& name) {
  for (const BondLaw& law : bond_laws())
    if (const Index at = law.find(name); at >= 0) return &law.parameters[std::size_t(at)];
  return nullptr;
}

/// Strengths and damping: what a bond file of any code has beside the stiffness.
bool is_kept(const std::string& name) {
  static const std::array<std::string_view, 12> parts{"strength", "cohesion", "adhesion",    "friction",
                                                      "damping",  "critical", "pb_ten",      "pb_coh",
                                                      "pb_fa",    "pb_mcf",   "restitution", "viscosity"};
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return name.find(part) != std::string::npos; });
}

/// Which dimension the unit of a kept column has; a fault names the unit where it is none of these.
Dimension kept_dimension(const ColumnName& heading) {
  for (const Dimension dimension :
       {dimension::stress, dimension::force, dimension::moment, dimension::stiffness})
    if (has_unit_of(heading, dimension)) return dimension;
  return dimension::none;
}

void move_column(std::map<std::string, std::vector<double>>& columns, const std::string& name, double factor,
                 TableColumn& from, std::vector<Fault>& faults) {
  if (columns.contains(name))
    faults.push_back({from.place, fmt::format("{} is given twice", name), "remove one of the columns"});
  std::vector<double>& to = columns[name] = std::move(from.numbers);
  if (factor != 1)
    for (double& number : to) number *= factor;
}

/// kn, ks, kt, kb of bonds that are given by their stiffness per area and their radius. [EDEM-V2] and PFC's
/// parallel bond say the same: Sn A, St A, St J, Sn J / 2.
void multiply_with_sections(ForeignModel& model) {
  auto& columns = model.bond_columns;
  const bool given = columns.contains("normal_stiffness") && columns.contains("shear_stiffness") &&
                     columns.contains("radius") && !columns.contains("kn");
  if (!given) return;
  const BondCode& edem = *find_bond_code("edem-bonding-v2");
  const std::size_t count = model.bonds.size();
  for (const char* name : {"kn", "ks", "kt", "kb"}) columns[name].resize(count, not_given);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = columns["radius"][i];
    const double normal = columns["normal_stiffness"][i], shear = columns["shear_stiffness"][i];
    if (std::isnan(radius) || std::isnan(normal) || std::isnan(shear)) continue;
    constexpr double disk_scale = 1, torque_feedback = 1;
    const BondSite site{.length = 2 * radius, .radius_a = radius, .radius_b = radius};
    const SectionStiffness stiffness =
        edem.realised(site, std::array{normal, shear, disk_scale, torque_feedback}).stiffness;
    columns["kn"][i] = stiffness.kn;
    columns["ks"][i] = stiffness.ks;
    columns["kt"][i] = stiffness.kt;
    columns["kb"][i] = stiffness.kb;
  }
  columns.erase("normal_stiffness");
  columns.erase("shear_stiffness");
  model.notes.taken.push_back(
      "kn, ks, kt, kb are stiffnesses per area times the sections of the bonds' radii, as in EDEM Bonding V2 "
      "and PFC's linear parallel bond.");
  if (!columns.contains("contact_point"))
    model.notes.assumed.push_back(
        "The table has no contact points. Those codes' bonds act at the centre of the gap: write "
        "contact_point = \"gap\" in [[bonds]].");
}

void take_types(TableColumn& type, ForeignModel& model) {
  std::vector<Index> number;
  bool renumbered = false;
  for (const std::string& word : type.words) {
    const auto whole = whole_number_field(word);
    number.push_back(whole && *whole >= 0 ? *whole : -1);
    renumbered |= number.back() < 0;
  }
  if (renumbered) {
    for (std::size_t i = 0; i < number.size(); ++i) number[i] = Index(i) + 1;
    model.notes.assumed.push_back(fmt::format("Bond types are numbered in the order in which they come: {}.",
                                              name_list(type.words).substr(0, 400)));
  }
  for (std::size_t i = 0; i < model.bonds.size(); ++i)
    model.bonds[i].type = number[std::size_t(type.numbers[i])];
}

}  // namespace

Wanted wanted_of_bonds(const std::string& name) {
  if (among(name, columns::bond_a) || among(name, columns::bond_b) || among(name, columns::bond_id))
    return Wanted::whole;
  if (among(name, columns::bond_type)) return Wanted::word;
  for (const KnownColumn& known : known_columns())
    if (among(name, known.aliases)) return Wanted::number_or_empty;
  return law_parameter(name) || is_kept(name) ? Wanted::number_or_empty : Wanted::no;
}

void take_bonds(TableColumns& table, ForeignModel& model, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  TableColumn* a = table.find(columns::bond_a, faults);
  TableColumn* b = table.find(columns::bond_b, faults);
  TableColumn* id = table.find(columns::bond_id, faults);
  TableColumn* type = table.find(columns::bond_type, faults);
  if (table.has(columns::kt) && !table.has(columns::ks))
    faults.push_back({table.find(columns::kt, faults)->place,
                      "column kt without ks: kt is the twisting stiffness here, not a tangential one",
                      "rename a tangential stiffness to ks"});
  if (id && faults.size() == before)
    table_of_ids("bond", {id->numbers.begin(), id->numbers.end()}, table.line, table.file, faults);
  if (faults.size() != before) return;
  model.bonds.resize(table.rows());
  for (std::size_t i = 0; i < model.bonds.size(); ++i)
    model.bonds[i] = {id ? Index(id->numbers[i]) : -1, Index(a->numbers[i]), Index(b->numbers[i]), -1};
  if (type) take_types(*type, model);

  std::vector<const TableColumn*> taken{a, b, id, type};
  std::vector<std::string> kept, values;
  UnitsSeen units;
  for (const KnownColumn& known : known_columns()) {
    TableColumn* column = table.find(known.aliases, faults);
    if (!column) continue;
    taken.push_back(column);
    std::string name = known.aliases.front();
    Dimension dimension = known.dimension;
    // "Normal Stiffness (N/m)" is that of the whole bond.
    if (dimension == dimension::stress_per_length && has_unit_of(column->heading, dimension::stiffness)) {
      dimension = dimension::stiffness;
      name = name == "normal_stiffness" ? "kn" : "ks";
    }
    const bool halve = &known.aliases == &columns::bond_diameter;
    if (halve) name = "radius";
    bring_to_si(*column, dimension, units, faults);
    move_column(model.bond_columns, name, halve ? 0.5 : 1, *column, faults);
    values.push_back(column->heading.text);
  }
  for (TableColumn& column : table.columns) {
    if (column.wanted != Wanted::number_or_empty ||
        std::find(taken.begin(), taken.end(), &column) != taken.end())
      continue;
    const Parameter* parameter = law_parameter(column.heading.name);
    taken.push_back(&column);
    bring_to_si(column, parameter ? parameter->dimension : kept_dimension(column.heading), units, faults);
    move_column(parameter ? model.bond_columns : model.kept_columns, column.heading.name, 1, column, faults);
    (parameter ? values : kept).push_back(column.heading.text);
  }
  if (faults.size() != before) return;
  multiply_with_sections(model);
  model.bond_line = std::move(table.line);

  model.si = note_units(units, table.edem, model.notes);
  std::string what = fmt::format("{} bonds", model.bonds.size());
  if (!values.empty()) what += fmt::format(", with {}", name_list(values));
  model.notes.taken.push_back(what + ".");
  if (!kept.empty())
    model.notes.left_out.push_back(fmt::format("Kept, not used by a static solve: {}.", name_list(kept)));
  note_columns_left(table, taken, "not taken", model.notes);
}

}  // namespace bondstatic
