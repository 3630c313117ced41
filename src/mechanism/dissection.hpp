// Nested dissection of a graph by the coordinates of its vertices.
#pragma once

#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// One node of the elimination tree. No edge joins vertices of two fronts unless one is an ancestor of the
/// other.
struct FrontShape {
  std::vector<Index> eliminated;  ///< vertices
  std::vector<Index> children;    ///< numbers of fronts, smaller than the front's own
};

/// Fronts in postorder, children before parents; every vertex is in exactly one.
std::vector<FrontShape> dissect(const std::vector<Vector3>& places,
                                const std::vector<std::vector<Index>>& neighbours);

}  // namespace bondstatic
