// Bonds listed in a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/bond_rows.hpp"
#include "case/table_reader.hpp"
#include "formats/foreign_model.hpp"
#include "io/table.hpp"

namespace bondstatic {

/// What a block's file has been read as: a table of this project, or another code's file.
struct BondFile {
  std::string path;
  std::optional<Table> table;
  std::optional<ForeignModel> foreign;

  /// kn, ks, kt and kb are there: law "generic" then goes without saying.
  bool gives_stiffness() const;
};

/// Nothing, and faults, where it cannot be read.
std::optional<BondFile> open_bond_file(Draft& draft, TableReader& block);

/// The file's rows, each with parameters that complete what the block itself gives to a sound whole, and with
/// strengths where the block has a criterion for them (null: it has none). Uses up the file.
std::optional<BondRows> bond_rows(Draft& draft, BondFile file, const BondLaw& law,
                                  const std::vector<double>& given, const GivenStrengths* strengths);

}  // namespace bondstatic
