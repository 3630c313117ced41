// Bonds that another code's file lists.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/bond_rows.hpp"
#include "formats/foreign_model.hpp"

namespace bondstatic {

/// Columns of the file that the law or the strength criterion takes are its bonds' own; what becomes of the
/// others is said in warnings. `strengths` may be null.
std::optional<BondRows> rows_of_foreign_bonds(Draft& draft, const std::string& path, ForeignModel model,
                                              const BondLaw& law, const std::vector<double>& given,
                                              const GivenStrengths* strengths = nullptr);

}  // namespace bondstatic
