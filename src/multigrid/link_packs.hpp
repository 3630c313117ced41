// The product K u of a level, link by link: eight links to a pack, never a matrix. Rows stand in blocks that
// fit into a core's cache; a link between two blocks is kept by both and answers in each for its own end
// only. So every body's forces are summed in one order, whatever the number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "multigrid/lanes.hpp"
#include "multigrid/packing.hpp"

namespace bondstatic::multigrid {

/// Rows of a block: motions and forces of so many bodies, links and all, stay in the second-level cache.
inline constexpr Index block_size = 2048;

/// Links of round sections, C as five numbers. Arms lie on the axis e: the contact point is at ta e from a,
/// and at -tb e from b.
template <class Scalar>
struct RoundPack {
  std::uint32_t a[pack_size], b[pack_size];
  Scalar axis[3][pack_size], ta[pack_size], tb[pack_size];
  Scalar kn[pack_size], ks[pack_size], kt[pack_size], kb[pack_size], coupling[pack_size];
};

/// Links with any symmetric C: the upper triangle, row by row.
template <class Scalar>
struct FullPack {
  std::uint32_t a[pack_size], b[pack_size];
  Scalar arm_a[3][pack_size], arm_b[3][pack_size];
  Scalar c[21][pack_size];
};

template <class LinkType, class Scalar>
struct PackOf {
  using Type = FullPack<Scalar>;
};
template <class Scalar>
struct PackOf<Link, Scalar> {
  using Type = RoundPack<Scalar>;
};

template <class Pack>
struct Block {
  Index first = 0, last = 0;  ///< rows
  std::vector<Pack> inside;   ///< both ends in the block
  std::vector<Pack> across;   ///< a in the block, b outside of it or ground
};

/// Row of each body, and body of each row, copies left out. Held bodies have no row; as the other end of a
/// link they stand for the row after the last, which is always zero. Copies that are not held follow behind
/// that.
struct Numbering {
  std::vector<Index> row, body;
};
inline constexpr Index no_row = -1;

/// Springs become links to the ground above the finest level, and are ignored there (see finest_packing).
template <class Scalar, class LinkType>
std::vector<Block<typename PackOf<LinkType, Scalar>::Type>> pack_links(const Packing<LinkType>& packing,
                                                                       const Numbering& numbering,
                                                                       int threads);

/// Adds K u of the block's rows to `product`, which begins with the block's first row. Vectors have `stride`
/// numbers a row.
void add_product(const Block<RoundPack<float>>& block, const float* u, float* product);
void add_product(const Block<RoundPack<float>>& block, const double* u, double* product);
void add_product(const Block<RoundPack<double>>& block, const double* u, double* product);
void add_product(const Block<FullPack<float>>& block, const float* u, float* product);
void add_product(const Block<FullPack<double>>& block, const double* u, double* product);

}  // namespace bondstatic::multigrid
