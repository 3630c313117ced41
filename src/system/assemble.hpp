// K in the unknowns of FreeDofs: lower triangle, compressed columns, 64-bit indices.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "bondstatic/network.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// Bodies that share a link: for each body the others, ascending, each once.
struct BodyGraph {
  std::vector<Index> offset;
  std::vector<Index> neighbour;
  bool operator==(const BodyGraph&) const = default;
};
BodyGraph body_graph(const BondNetwork& network, const Incidence& incidence);

/// The pattern of the lower triangle of K with dense blocks; values are zero.
SparseMatrix stiffness_pattern(const BodyGraph& graph, const FreeDofs& dofs);

/// Overwrites the values of a matrix with that pattern by K, rotations times network.rotation_length. Each
/// column is summed over its body's links in ascending order, so that the bits do not depend on `threads`.
void assemble(const BondNetwork& network, const Incidence& incidence, const BodyGraph& graph,
              const FreeDofs& dofs, int threads, SparseMatrix& k);

}  // namespace bondstatic
