// What a sweep is drawn over, and as which curves.
#pragma once

#include <string>
#include <vector>

#include "report/page_data.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic {

/// Without ordinates yet. Columns are those of keys, counts and `outputs`; each that varies is an abscissa.
/// The first one is the key with the most numbers, or the number of bonds where that key is a count of
/// particles.
PageSweep sweep_curves(const SweepTable& sweep, const std::vector<SweepColumn>& outputs);

/// "law = parallel, poisson = 0.3", row by row.
std::vector<std::string> row_names(const SweepTable& sweep, const std::vector<const SweepKey*>& keys);

}  // namespace bondstatic
