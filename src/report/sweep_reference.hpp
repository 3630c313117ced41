// What the points of a sweep are compared with.
#pragma once

#include <string>
#include <vector>

#include "report/sweep_table.hpp"

namespace bondstatic {

/// The first value of the first key that counts names, of laws the beam that is exact for any number of
/// bonds.
struct SweepReference {
  std::string name;  ///< "law = timoshenko"; "" where no key counts names
  std::vector<std::size_t>
      rows;  ///< for each row that with this value and all other keys the same, or rows()
};

SweepReference reference_of(const SweepTable& sweep);

/// In percent of the reference, row by row; NaN for the reference itself and where there is none.
std::vector<double> differences(const std::vector<double>& values, const SweepReference& reference);

/// Whether there are differences, and not by rounding only.
bool differ(const std::vector<double>& differences);

}  // namespace bondstatic
