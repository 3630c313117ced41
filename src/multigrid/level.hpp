// What a level holds to work with: packed links, inverse diagonal blocks, where its clumps are, and room for
// vectors. Rows are numbered so that a clump's follow each other, clump after clump as the coarser level
// numbers them: neighbours in space are neighbours in memory on every level.
#pragma once

#include <variant>
#include <vector>

#include "io/first_touch.hpp"
#include "multigrid/block_diagonal.hpp"
#include "multigrid/link_packs.hpp"

namespace bondstatic::multigrid {

/// One body's motion or force.
template <class Scalar>
struct alignas(stride * sizeof(Scalar)) Row {
  Scalar at[stride] = {};
};
template <class Scalar>
using Rows = std::vector<Row<Scalar>>;

/// A vector of so many rows, all zero: behind them one for the ground, one for each copy, and room for whole
/// packs.
template <class Scalar>
Rows<Scalar> make_rows(Index rows, Index copies = 0, int threads = 1) {
  const Index packs = (rows + copies + pack_size) / pack_size;
  return vector_of<Row<Scalar>>(std::size_t(packs * pack_size), threads);
}

/// A body that is held in some degrees of freedom: bit i of `free` as in FreeDofs.
struct PartlyHeld {
  Index row = 0;
  std::uint8_t free = 0;
};

template <class Scalar>
struct Level {
  Index bodies = 0;  ///< rows to work on; behind them one for the ground, then the copies
  Index copies = 0;
  Halo halo;  ///< of rows
  std::variant<std::vector<Block<RoundPack<Scalar>>>, std::vector<Block<FullPack<Scalar>>>> links;
  std::vector<InversePack<Scalar>> inverse;
  std::vector<PartlyHeld> partly_held;  ///< ascending rows; on the finest level only

  std::vector<Index> clump_first;             ///< first row of each clump, and the end; empty on the coarsest
  std::vector<std::array<Scalar, 3>> offset;  ///< from the clump's centre to the body's, by row

  Rows<Scalar> x, r;                   ///< correction and residual of the cycle
  Rows<Scalar> d, e;                   ///< its directions
  Rows<Scalar> given, first, product;  ///< of the K-cycle: right-hand side, first correction, K times that
};

/// Zero in the degrees of freedom that are held.
template <class Scalar, class Number>
void leave_out_held(const Level<Scalar>& level, Rows<Number>& v) {
  for (const PartlyHeld& body : level.partly_held)
    for (int i = 0; i < 6; ++i)
      if (!((body.free >> i) & 1)) v[std::size_t(body.row)].at[i] = 0;
}

}  // namespace bondstatic::multigrid
