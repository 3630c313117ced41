// Bonds listed in a file.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "case/draft.hpp"
#include "case/row_places.hpp"
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

struct BondRows {
  std::vector<Index> a, b;  ///< model positions
  std::vector<Index> ids;   ///< empty where there is no such column
  RowPlaces places;
  std::map<std::size_t, std::vector<double>> overrides;  ///< as in BondBlock
  std::vector<double> fractions;                         ///< as in BondBlock
};

/// The file's rows, each with parameters that complete what the block itself gives to a sound whole. Uses up
/// the file.
std::optional<BondRows> bond_rows(Draft& draft, BondFile file, const BondLaw& law,
                                  const std::vector<double>& given);

}  // namespace bondstatic
