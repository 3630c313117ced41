#include "multigrid/flexible_cg.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "multigrid/block_loop.hpp"
#include "multigrid/cycle.hpp"

namespace bondstatic::multigrid {

namespace {

// Sums over all rows of a . b and, where it is asked for, a . c.
template <class A, class B>
std::array<double, 2> dots(const Halo& halo, const Rows<A>& a, const Rows<B>& b, const Rows<B>& c, Index rows,
                           int threads) {
  BlockSums<2> sums(rows);
  for_blocks(rows, threads, [&](Index block, Index first, Index last) {
    const Row<A>* of = a.data() + first;
    sums[block] = {dot(of, b.data() + first, last - first),
                   &c == &b ? 0 : dot(of, c.data() + first, last - first)};
  });
  return sums.total(halo);
}

// kp = K p without the rows of what is held; returns p . kp and p . r.
template <class Scalar>
std::array<double, 2> apply(const Level<Scalar>& level, Rows<double>& p, const Rows<double>& r,
                            Rows<double>& kp, int threads) {
  const auto& blocks = std::get<std::vector<Block<RoundPack<Scalar>>>>(level.links);
  const auto& held = level.partly_held;
  BlockSums<2> sums(level.bodies);
  for_products(
      blocks, level.halo, p, threads,
      [&](Index block, Index first, Index last, Rows<double>& product, Rows<double>&) {
        const auto before = [](const PartlyHeld& body, Index row) { return body.row < row; };
        for (auto body = std::lower_bound(held.begin(), held.end(), first, before);
             body != held.end() && body->row < last; ++body)
          for (int i = 0; i < 6; ++i)
            if (!((body->free >> i) & 1)) product[std::size_t(body->row - first)].at[i] = 0;
        std::copy_n(product.begin(), last - first, kp.begin() + first);
        const Row<double>* along = p.data() + first;
        sums[block] = {dot(along, product.data(), last - first), dot(along, r.data() + first, last - first)};
      });
  return sums.total(level.halo);
}

}  // namespace

template <class Scalar>
Convergence flexible_cg(Hierarchy<Scalar>& hierarchy, const Goal& goal, int threads, Rows<double>& r,
                        Rows<double>& x) {
  Level<Scalar>& level = hierarchy.levels.front();
  const Index rows = level.bodies;
  Rows<double> p = make_rows<double>(rows, level.copies, threads), kp = make_rows<double>(rows, 0, threads);
  x = make_rows<double>(rows, level.copies, threads);
  Convergence result;
  const double start = std::sqrt(dots(level.halo, r, r, r, rows, threads)[0]);
  if (!(start > 0)) return {0, 0, start == 0};

  double size = start, curvature = 0, energy = 0, energy_at_start = 0, best = 0;
  int best_at = 0;
  while (result.iterations < goal.most_iterations) {
    // z = M r; what the cycle sees is scaled to 1, so that float keeps its range.
    for_blocks(rows, threads, [&](Index, Index first, Index last) {
      for_numbers(first, last,
                  [&](std::size_t row, int i) { level.r[row].at[i] = Scalar(r[row].at[i] / size); });
    });
    cycle(hierarchy, threads);
    const Rows<Scalar>& z = level.x;
    const auto [zr, zkp] = dots(level.halo, z, r, kp, rows, threads);
    if (!(zr > 0) || !std::isfinite(zr)) break;  // rounding has made the cycle indefinite
    const double before = std::exchange(energy, std::sqrt(size * zr));
    if (result.iterations == 0) energy_at_start = best = energy;
    if (energy < best) {
      best = energy;
      best_at = result.iterations;
    }
    if (result.iterations - best_at > goal.patience) break;
    // What the step at hand will leave, if it does as well as the last: to know it would take a cycle more.
    const double contraction = result.iterations > 0 ? std::min(1.0, energy / before) : 1;

    const double along = result.iterations > 0 ? size * zkp / curvature : 0;
    for_blocks(rows, threads, [&](Index, Index first, Index last) {
      for_numbers(first, last, [&](std::size_t row, int i) {
        p[row].at[i] = size * double(z[row].at[i]) - along * p[row].at[i];
      });
    });
    const auto [pkp, pr] = apply(level, p, r, kp, threads);
    curvature = pkp;
    if (!(curvature > 0)) break;
    const double step = pr / curvature;
    BlockSums<1> left(rows);
    for_blocks(rows, threads, [&](Index block, Index first, Index last) {
      for_numbers(first, last, [&](std::size_t row, int i) {
        x[row].at[i] += step * p[row].at[i];
        r[row].at[i] -= step * kp[row].at[i];
      });
      left[block] = {dot(r.data() + first, r.data() + first, last - first)};
    });
    size = std::sqrt(left.total(level.halo)[0]);
    ++result.iterations;
    result.reduction = size / start;
    result.reached = size == 0 || contraction * energy <= goal.energy_reduction * energy_at_start;
    if (result.reached || !(size > 0)) break;
  }
  return result;
}

template Convergence flexible_cg(Hierarchy<float>&, const Goal&, int, Rows<double>&, Rows<double>&);
template Convergence flexible_cg(Hierarchy<double>&, const Goal&, int, Rows<double>&, Rows<double>&);

}  // namespace bondstatic::multigrid
