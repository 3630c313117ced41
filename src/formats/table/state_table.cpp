// Tables as states of a run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "formats/particle_ids.hpp"
#include "formats/table/column_units.hpp"
#include "formats/table/columns.hpp"
#include "formats/table/foreign_table.hpp"
#include "formats/table/model.hpp"
#include "io/nearest_name.hpp"
#include "io/number_field.hpp"
#include "model/turning.hpp"

namespace bondstatic {
namespace {

constexpr Dimension angular_velocity_dimension{0, 0, -1};

const Aliases own_displacement[3] = {{"ux"}, {"uy"}, {"uz"}};

Wanted wanted_of_state(const ColumnName& heading, TableKind) {
  const std::string& name = heading.name;
  if (among(name, columns::particle_id)) return Wanted::whole;
  if (among(name, columns::radius) || among(name, columns::diameter)) return Wanted::positive;
  if (name == "type" || name == "type_id" || name == "particle_type") return Wanted::word;
  for (const Aliases* axis : {&columns::x, &columns::y, &columns::z})
    if (among(name, *axis)) return Wanted::number;
  for (const auto* vector : {&columns::rotation, &columns::velocity, &columns::angular_velocity,
                             &columns::force, &columns::torque, &columns::quaternion})
    for (const Aliases& component : *vector)
      if (among(name, component)) return Wanted::number;
  for (const Aliases& component : own_displacement)
    if (among(name, component)) return Wanted::number;
  return Wanted::no;
}

/// All components of a vector or quaternion, or none. Only some of them are a fault, or where `notes` is
/// given a note that they are not taken.
std::vector<TableColumn*> components(TableColumns& table, std::span<const Aliases> aliases,
                                     std::vector<std::string>* notes, std::vector<Fault>& faults) {
  std::vector<TableColumn*> found;
  std::string missing;
  for (const Aliases& component : aliases) {
    if (TableColumn* column = table.find(component, faults))
      found.push_back(column);
    else if (missing.empty())
      missing = component.front();
  }
  if (missing.empty() || found.empty()) return found;
  const std::string what = fmt::format("column {} lacks its companion {}", found[0]->heading.text, missing);
  if (notes)
    notes->push_back(fmt::format("Not taken: {}.", what));
  else
    faults.push_back({found[0]->place, what, "add the column, of zeros if need be, or rename this one"});
  return {};
}

std::vector<Vector3> vectors(TableColumns& table, std::span<const Aliases> aliases, Dimension dimension,
                             std::vector<std::string>* notes, std::vector<Fault>& faults) {
  const std::vector<TableColumn*> component = components(table, aliases, notes, faults);
  if (component.empty()) return {};
  UnitsSeen units;
  std::vector<Vector3> out(table.rows());
  for (int i = 0; i < 3; ++i) {
    TableColumn& column = *component[std::size_t(i)];
    bring_to_si(column, dimension, units, faults);
    for (std::size_t row = 0; row < out.size(); ++row) out[row][i] = column.numbers[row];
  }
  return out;
}

std::vector<Eigen::Quaterniond> orientations(TableColumns& table, std::vector<Fault>& faults) {
  std::vector<Eigen::Quaterniond> out;
  const std::vector<TableColumn*> part = components(table, columns::quaternion, nullptr, faults);
  if (part.empty()) {
    for (const Vector3& rotation : vectors(table, columns::rotation, dimension::none, nullptr, faults))
      out.push_back(quaternion(rotation));
    return out;
  }
  LimitedFaults limited(faults);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Eigen::Quaterniond q(part[0]->numbers[row], part[1]->numbers[row], part[2]->numbers[row],
                               part[3]->numbers[row]);
    // Printed with six digits, a quaternion is off 1 by far less.
    if (std::abs(q.norm() - 1) > 1e-2)
      limited.add({table.file, table.line[row], 1},
                  fmt::format("the quaternion has the norm {}, which must be 1", q.norm()),
                  "give an orientation as qw, qx, qy, qz, or as a rotation vector rx, ry, rz");
    out.push_back(q.normalized());
  }
  return out;
}

}  // namespace

std::optional<ParticleState> read_state_table(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  auto table = read_table_columns(path, options, wanted_of_state, named_at, faults);
  if (!table) return std::nullopt;
  TableColumn* id = table->find(columns::particle_id, faults);
  if (kind_of(*table) != TableKind::particles)
    fault_unknown_kind(*table, faults);
  else if (!id)
    faults.push_back({table->header, "no column id: the particles of a state are told by their ids",
                      "add a column id, or one of: " + name_list(columns::particle_id)});
  if (faults.size() != before) return std::nullopt;

  ParticleState state;
  state.step = options.step.value_or(0);
  state.time = table->time;
  state.id.assign(id->numbers.begin(), id->numbers.end());
  table_of_ids("particle", state.id, table->line, path, faults);
  state.position = vectors(*table, std::vector<Aliases>{columns::x, columns::y, columns::z},
                           dimension::length, nullptr, faults);
  const std::vector<Vector3> displacement =
      vectors(*table, own_displacement, dimension::length, nullptr, faults);
  for (std::size_t i = 0; i < displacement.size(); ++i) state.position[i] += displacement[i];
  state.unwrapped = !displacement.empty();
  state.orientation = orientations(*table, faults);
  state.velocity = vectors(*table, columns::velocity, dimension::velocity, &state.notes, faults);
  state.angular_velocity =
      vectors(*table, columns::angular_velocity, angular_velocity_dimension, &state.notes, faults);
  state.force = vectors(*table, columns::force, dimension::force, &state.notes, faults);
  state.torque = vectors(*table, columns::torque, dimension::moment, &state.notes, faults);
  TableColumn* radius = table->find(columns::radius, faults);
  TableColumn* size = radius ? radius : table->find(columns::diameter, faults);
  if (size) {
    UnitsSeen units;
    bring_to_si(*size, dimension::length, units, faults);
    state.radius = std::move(size->numbers);
    if (!radius)
      for (double& value : state.radius) value /= 2;
  }
  if (const TableColumn* type = table->find({"type", "type_id", "particle_type"}, faults)) {
    std::vector<std::optional<Index>> number;
    for (const std::string& word : type->words) number.push_back(whole_number_field(word));
    if (std::all_of(number.begin(), number.end(), [](const auto& known) { return known.has_value(); }))
      for (const double at : type->numbers) state.type.push_back(*number[std::size_t(at)]);
  }
  if (faults.size() != before) return std::nullopt;
  return state;
}

std::optional<BondState> read_bond_state_table(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  const auto want = [](const ColumnName& heading, TableKind) {
    const bool end = among(heading.name, columns::bond_a) || among(heading.name, columns::bond_b);
    return end ? Wanted::whole : Wanted::number_if_any;
  };
  auto table = read_table_columns(path, options, want, named_at, faults);
  if (!table) return std::nullopt;
  const TableColumn* a = table->find(columns::bond_a, faults);
  const TableColumn* b = table->find(columns::bond_b, faults);
  if (!a || !b)
    faults.push_back({table->header, "no columns a, b: bonds are told by the ids of their particles",
                      "add columns a and b"});
  if (faults.size() != before) return std::nullopt;
  BondState state;
  state.step = options.step.value_or(0);
  state.a.assign(a->numbers.begin(), a->numbers.end());
  state.b.assign(b->numbers.begin(), b->numbers.end());
  for (TableColumn& column : table->columns) {
    if (&column == a || &column == b || column.heading.text.empty()) continue;
    const auto is_number = [](double number) { return !std::isnan(number); };
    if (std::any_of(column.numbers.begin(), column.numbers.end(), is_number))
      state.columns[column.heading.text] = std::move(column.numbers);
  }
  return state;
}

}  // namespace bondstatic
