// Bonds listed in a file.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "case/draft.hpp"
#include "case/row_places.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

struct BondRows {
  std::vector<Index> a, b;  ///< model positions
  std::vector<Index> ids;   ///< empty where there is no such column
  RowPlaces places;
  std::map<std::size_t, std::vector<double>> overrides;  ///< as in BondBlock
};

/// The rows of the block's file, each with parameters that complete what the block itself gives to a sound
/// whole.
std::optional<BondRows> read_bond_file(Draft& draft, TableReader& block, const BondLaw& law,
                                       const std::vector<double>& given);

}  // namespace bondstatic
