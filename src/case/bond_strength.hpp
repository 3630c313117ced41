// `strength` of a [[bonds]] block: when its bonds break.
//
//   strength = { criterion = "edem-v2", critical_normal_stress = "5 MPa", critical_shear_stress = "8 MPa" }
//
// The criterion's own strengths and numbers; those that a column of the bond file gives may be left out. They
// may scatter from bond to bond:
//
//   scatter = "weibull", modulus = 8         the given strength is the scale
//   scatter = "normal", variation = 0.2      coefficient of variation
//   scatter = "uniform", range = "1 MPa"     strength -+ range
//   seed = 1, together = false               true: one draw a bond for all its strengths
//
// One number is for all strengths; a table gives it for some: variation = { tensile_strength = 0.3 }. Without
// a strength bonds never break.
#pragma once

#include <optional>

#include "case/bond_rows.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// Nothing where the block has none, or a fault.
std::optional<GivenStrengths> read_strength(TableReader& block);

/// Faults where strengths are missing or out of bounds, unless `rows` bring their own, which are checked
/// already, and where the criterion speaks of stresses, but bonds have no section: the law leaves it open
/// (contact, generic), and neither the block (`given`, of the law) nor the row gives its radius. Fills in
/// the defaults, and writes them back. `rows`: of the block's file; null: it has none.
void check_strength(TableReader& block, GivenStrengths& strengths, const BondLaw& law,
                    const std::vector<double>& given, const BondRows* rows);

}  // namespace bondstatic
