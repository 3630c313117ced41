// Files of other codes where a case names a file: LAMMPS data and dumps, YADE, EDEM, MUSEN, PFC, ...
#pragma once

#include <optional>
#include <string>

#include "case/table_reader.hpp"
#include "formats/readers.hpp"

namespace bondstatic {

enum class WantedOf { particles, bonds };

/// Whether the file is of a format other than a table with a header line. Files that cannot be read are none:
/// whoever reads tables says what is wrong with them.
bool is_foreign_file(const std::string& path);

/// Reads it as the block asks: atom_style, step, and for bonds bond_columns. What the reader assumes becomes
/// a warning.
std::optional<ForeignModel> read_foreign_file(TableReader& block, const std::string& path, WantedOf wanted);

/// The same for a table with a header line. Nothing, and no faults, where the header has one of `own`, names
/// of this project's columns in lower case, or where it is no other code's table, either.
std::optional<ForeignModel> try_foreign_table(TableReader& block, const std::string& path, WantedOf wanted,
                                              const std::vector<std::string>& own);

/// Makes the keys of the block known that only such files need.
void accept_foreign_keys(TableReader& block, WantedOf wanted);

}  // namespace bondstatic
