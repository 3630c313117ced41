// Loops over the blocks of a level. Sums are kept by block and added up in order: the same bits on any number
// of threads.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "multigrid/level.hpp"

namespace bondstatic::multigrid {

/// Fewer blocks than this run on one thread: waking the others would take longer.
inline constexpr Index worth_waking = 4;

inline Index block_count(Index rows) {
  return (rows + block_size - 1) / block_size;
}

/// Calls work(block, first row, last row) for all blocks of rows.
template <class Work>
void for_blocks(Index rows, int threads, Work&& work) {
  const Index count = block_count(rows);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && count >= worth_waking)
  for (Index block = 0; block < count; ++block)
    work(block, block * block_size, std::min(rows, (block + 1) * block_size));
}

/// Calls work(block, first row, last row, product, spare) for all blocks; product[0] ... are rows first ...
/// of K u, and spare has room for as many. Copies in u are brought up to date before.
template <class Scalar, class Packs, class Work>
void for_products(const std::vector<Block<Packs>>& blocks, const Halo& halo, Rows<Scalar>& u, int threads,
                  Work&& work) {
  refresh(halo, u);
  const Index count = Index(blocks.size());
  const Index largest = count > 0 ? blocks.front().last : 0;
#pragma omp parallel num_threads(threads) if (threads > 1 && count >= worth_waking)
  {
    Rows<Scalar> product = make_rows<Scalar>(largest), spare = make_rows<Scalar>(largest);
#pragma omp for schedule(static)
    for (Index k = 0; k < count; ++k) {
      const auto& block = blocks[std::size_t(k)];
      std::fill_n(product.begin(), block.last - block.first, Row<Scalar>{});
      add_product(block, u.front().at, product.front().at);
      work(k, block.first, block.last, product, spare);
    }
  }
}

template <class Scalar, class Work>
void for_products(const Level<Scalar>& level, Rows<Scalar>& u, int threads, Work&& work) {
  std::visit([&](const auto& blocks) { for_products(blocks, level.halo, u, threads, work); }, level.links);
}

template <std::size_t Count>
class BlockSums {
 public:
  explicit BlockSums(Index rows) : part_(std::size_t(block_count(rows))) {}
  std::array<double, Count>& operator[](Index block) { return part_[std::size_t(block)]; }
  /// Over all ranks that share the rows.
  std::array<double, Count> total(const Halo& halo) const {
    std::array<double, Count> sum{};
    for (const auto& part : part_)
      for (std::size_t i = 0; i < Count; ++i) sum[i] += part[i];
    return over_all_ranks(halo, sum);
  }

 private:
  std::vector<std::array<double, Count>> part_;
};

template <class A, class B>
double dot(const Row<A>* a, const Row<B>* b, Index rows) {
  double lane[stride] = {};
  for (Index p = 0; p < rows; ++p)
    for (int i = 0; i < stride; ++i) lane[i] += double(a[p].at[i]) * double(b[p].at[i]);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + (lane[4] + lane[5]);
}

/// Calls work(row, number) for every number of rows first ... last - 1.
template <class Work>
void for_numbers(Index first, Index last, Work&& work) {
  for (Index row = first; row < last; ++row)
    for (int i = 0; i < stride; ++i) work(std::size_t(row), i);
}

}  // namespace bondstatic::multigrid
