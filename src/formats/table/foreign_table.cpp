#include "formats/table/foreign_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/table/columns.hpp"
#include "formats/table/model.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

Wanted wanted_of_model(const ColumnName& heading, TableKind kind) {
  if (kind == TableKind::bonds) return wanted_of_bonds(heading.name);
  const Wanted particles = wanted_of_particles(heading.name);
  return kind == TableKind::unknown && particles == Wanted::no ? wanted_of_bonds(heading.name) : particles;
}

/// The preface of an EDEM export is known to be one.
void note_lines_left(const TableColumns& table, ImportNotes& notes) {
  if (table.edem || table.left_lines.empty()) return;
  notes.left_out.push_back(fmt::format("{} line{} above the header: \"{}\"{}", table.left_lines.size(),
                                       table.left_lines.size() == 1 ? "" : "s", table.left_lines.front(),
                                       table.left_lines.size() == 1 ? "." : " ..."));
}

}  // namespace

void note_columns_left(const TableColumns& table, const std::vector<const TableColumn*>& taken,
                       const std::string& why, ImportNotes& notes) {
  std::vector<std::string> left;
  for (const TableColumn& column : table.columns)
    if (std::find(taken.begin(), taken.end(), &column) == taken.end() && !column.heading.text.empty())
      left.push_back(column.heading.text.substr(0, 60));
  if (!left.empty()) notes.left_out.push_back(fmt::format("Columns {}: {}.", why, name_list(left)));
}

std::optional<ForeignModel> read_foreign_table(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  auto table = read_table_columns(path, options, wanted_of_model, named_at, faults);
  if (!table) return std::nullopt;
  ForeignModel model;
  const TableKind kind = kind_of(*table);
  const std::string of = table->edem ? "EDEM results export" : "table";
  if (kind == TableKind::unknown) {
    fault_unknown_kind(*table, faults);
  } else if (kind == TableKind::particles && !options.particles) {
    faults.push_back({table->header, "the table has particles, where bonds are asked for",
                      "give a table with the columns a, b: the ids of each bond's particles"});
  } else if (kind == TableKind::bonds && !options.bonds) {
    faults.push_back({table->header, "the table has bonds, where particles are asked for",
                      "give a table with the columns x, y, z"});
  } else if (kind == TableKind::particles) {
    model.format = of + " of particles";
    take_particles(*table, model, faults);
  } else {
    model.format = of + " of bonds";
    take_bonds(*table, model, faults);
  }
  note_lines_left(*table, model.notes);
  if (faults.size() != before) return std::nullopt;
  return model;
}

}  // namespace bondstatic
