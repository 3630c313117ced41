#include "case/bond_file.hpp"

#include <fmt/format.h>

#include <span>

#include "case/bond_table.hpp"
#include "case/foreign_bonds.hpp"
#include "case/foreign_file.hpp"
#include "formats/table/column_names.hpp"

namespace bondstatic {

bool BondFile::gives_stiffness() const {
  std::vector<Fault> unsaid;
  for (const std::string& name : stiffness_names)
    if (foreign ? !foreign->bond_columns.contains(name) : table->find(std::span(&name, 1), unsaid) < 0)
      return false;
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
  if (file.table && has_bond_ends(*file.table)) return file;
  // A table without this project's columns may be another code's.
  file.foreign = try_foreign_table(block, *path, WantedOf::bonds, own_columns::bond_a);
  if (!file.foreign) return file.table ? std::optional(std::move(file)) : std::nullopt;
  faults.resize(before);
  return file;
}

std::optional<BondRows> bond_rows(Draft& draft, BondFile file, const BondLaw& law,
                                  const std::vector<double>& given, const GivenStrengths* strengths) {
  const std::size_t before = draft.reading.faults.size();
  auto rows = file.foreign
                  ? rows_of_foreign_bonds(draft, file.path, std::move(*file.foreign), law, given, strengths)
                  : rows_of_bond_table(draft, *file.table, law, given, strengths);
  if (rows && draft.reading.faults.size() == before) check_ends(draft, *rows);
  if (draft.reading.faults.size() != before) return std::nullopt;
  return rows;
}

}  // namespace bondstatic
