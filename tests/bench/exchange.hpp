// Packings of growing size from a LAMMPS data file to a case, and bonds formed by contact radii: time and
// memory, whose growth shows.
#pragma once

#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

/// About so many particles each.
void print_exchange(const std::vector<Index>& sizes);

}  // namespace bondstatic::bench
