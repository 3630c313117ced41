// What the columns of the grids mean: unit, and whether their sign says something.
#pragma once

#include "report/page_data.hpp"
#include "report/read_grid.hpp"

namespace bondstatic {

PageColumn page_column(const GridArray& array, bool si);

/// Of one quantity, by its name in the files of results; "" where it has none, or where the case has units of
/// its own.
std::string unit_of(const std::string& name, bool si);

}  // namespace bondstatic
