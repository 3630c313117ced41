// Bonds in a table of this project: columns a, b and, where wanted, id, contact_point, parameters of the law,
// strengths.
#pragma once

#include <optional>
#include <vector>

#include "case/bond_rows.hpp"
#include "io/table.hpp"

namespace bondstatic {

/// Whether it has columns for both ends under names of this project's tables.
bool has_bond_ends(const Table& table);

/// Columns that are neither the law's nor the strength criterion's are named in a warning, or are faults
/// where they look like a slip. `strengths` may be null.
std::optional<BondRows> rows_of_bond_table(Draft& draft, const Table& table, const BondLaw& law,
                                           const std::vector<double>& given, const GivenStrengths* strengths);

}  // namespace bondstatic
