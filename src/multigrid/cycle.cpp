#include "multigrid/cycle.hpp"

#include "multigrid/block_loop.hpp"
#include "multigrid/smoother.hpp"
#include "multigrid/transfer.hpp"

namespace bondstatic::multigrid {

namespace {

// Clumps cannot bend, so the coarser packing is too stiff and its answer too small (Braess, Computing 55,
// 1995).
constexpr double over_correction = 1.4;

// The second step of a K-cycle is taken where the first leaves more than this of the residual.
constexpr double enough = 0.25;

template <class Scalar>
void ask_coarser(Hierarchy<Scalar>& h, std::size_t l, int threads);

template <class Scalar>
void cycle_from(Hierarchy<Scalar>& h, std::size_t l, int threads) {
  Level<Scalar>& level = h.levels[l];
  if (l + 1 == h.levels.size()) {
    h.coarsest.solve(level.halo, level.bodies, level.r, level.x);
    return;
  }
  Level<Scalar>& coarse = h.levels[l + 1];
  smooth_from_zero(level, threads);
  gather_on_clumps(level, coarse, threads);
  ask_coarser(h, l + 1, threads);
  move_with_clumps(coarse, level, over_correction, threads);
  smooth_after_step(level, threads);
}

// With c the first correction and d the second, x = s c + t d minimises the energy of the error:
// c.Kc s + c.Kd t = c.g, and the same for d.
template <class Scalar>
void ask_coarser(Hierarchy<Scalar>& h, std::size_t l, int threads) {
  if (l + 1 == h.levels.size()) return cycle_from(h, l, threads);
  Level<Scalar>& level = h.levels[l];
  const Index rows = level.bodies;
  level.given = level.r;
  cycle_from(h, l, threads);
  level.first = level.x;
  BlockSums<3> sums(rows);
  for_products(
      level, level.first, threads,
      [&](Index block, Index first, Index last, Rows<Scalar>& kc, Rows<Scalar>&) {
        std::copy_n(kc.begin(), last - first, level.product.begin() + first);
        const Row<Scalar>*c = level.first.data() + first, *g = level.given.data() + first;
        sums[block] = {dot(c, kc.data(), last - first), dot(c, g, last - first), dot(g, g, last - first)};
      });
  const auto [ckc, cg, gg] = sums.total(level.halo);
  if (!(ckc > 0)) return;  // only in float, where K is indefinite by rounding: the outer iteration sees to it

  const double step = cg / ckc;
  BlockSums<1> left(rows);
  for_blocks(rows, threads, [&](Index block, Index first, Index last) {
    for_numbers(first, last, [&](std::size_t row, int i) {
      level.given[row].at[i] -= Scalar(step) * level.product[row].at[i];
    });
    const Row<Scalar>* g = level.given.data() + first;
    left[block] = {dot(g, g, last - first)};
  });
  double c_share = step, d_share = 0;
  if (left.total(level.halo)[0] > enough * enough * gg) {
    level.r = level.given;
    cycle_from(h, l, threads);
    BlockSums<3> second(rows);
    for_products(level, level.x, threads,
                 [&](Index block, Index first, Index last, Rows<Scalar>& kd, Rows<Scalar>&) {
                   const Row<Scalar>* d = level.x.data() + first;
                   second[block] = {dot(d, kd.data(), last - first),
                                    dot(d, level.product.data() + first, last - first),
                                    dot(d, level.given.data() + first, last - first)};
                 });
    const auto [dkd, dkc, dg] = second.total(level.halo);
    if (const double rest = dkd - dkc * dkc / ckc; rest > 0) {
      d_share = dg / rest;
      c_share -= d_share * dkc / ckc;
    }
  }
  for_blocks(rows, threads, [&](Index, Index first, Index last) {
    for_numbers(first, last, [&](std::size_t row, int i) {
      const Scalar d = d_share != 0 ? Scalar(d_share) * level.x[row].at[i] : Scalar(0);
      level.x[row].at[i] = Scalar(c_share) * level.first[row].at[i] + d;
    });
  });
}

}  // namespace

template <class Scalar>
void cycle(Hierarchy<Scalar>& hierarchy, int threads) {
  cycle_from(hierarchy, 0, threads);
}

template void cycle(Hierarchy<float>&, int);
template void cycle(Hierarchy<double>&, int);

}  // namespace bondstatic::multigrid
