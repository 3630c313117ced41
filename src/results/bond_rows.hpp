// Rows of bonds: where exactly two bonds meet they belong to one row; a row ends where one bond or more than
// two are.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// Of each bond of the model, in its order.
struct UnbranchedRows {
  std::vector<Index> length;     ///< bonds of its row, itself included
  std::vector<bool> unbranched;  ///< at most two bonds meet at either end
};
UnbranchedRows bond_rows(const Model& model);

}  // namespace bondstatic
