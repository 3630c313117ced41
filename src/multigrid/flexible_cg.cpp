#include "multigrid/flexible_cg.hpp"

#include <cmath>

#include "multigrid/block_loop.hpp"
#include "multigrid/cycle.hpp"

namespace bondstatic::multigrid {

namespace {

template <class A, class B>
double dot(const Rows<A>& a, const Rows<B>& b, Index rows, int threads) {
  BlockSums<1> sums(rows);
  for_blocks(rows, threads, [&](Index block, Index first, Index last) {
    sums[block] = {dot(a.data() + first, b.data() + first, last - first)};
  });
  return sums.total()[0];
}

// kp = K p without the rows of what is held; returns p . kp.
template <class Scalar>
double apply(const Level<Scalar>& level, const Rows<double>& p, Rows<double>& kp, int threads) {
  const auto& blocks = std::get<std::vector<Block<RoundPack<Scalar>>>>(level.links);
  for_products(blocks, p, threads, [&](Index, Index first, Index last, Rows<double>& product, Rows<double>&) {
    std::copy_n(product.begin(), last - first, kp.begin() + first);
  });
  leave_out_held(level, kp);
  return dot(p, kp, level.bodies, threads);
}

}  // namespace

template <class Scalar>
Convergence flexible_cg(Hierarchy<Scalar>& hierarchy, const Goal& goal, int threads, Rows<double>& r,
                        Rows<double>& x) {
  Level<Scalar>& level = hierarchy.levels.front();
  const Index rows = level.bodies;
  Rows<double> p = make_rows<double>(rows), kp = make_rows<double>(rows);
  x = make_rows<double>(rows);
  Convergence result;
  const double start = std::sqrt(dot(r, r, rows, threads));
  if (!(start > 0)) return {0, 0, start == 0};

  double size = start, curvature = 0, energy_at_start = 0, best = 0;
  int best_at = 0;
  while (result.iterations < goal.most_iterations) {
    // z = M r; what the cycle sees is scaled to 1, so that float keeps its range.
    for_blocks(rows, threads, [&](Index, Index first, Index last) {
      for_numbers(first, last,
                  [&](std::size_t row, int i) { level.r[row].at[i] = Scalar(r[row].at[i] / size); });
    });
    cycle(hierarchy, threads);
    const Rows<Scalar>& z = level.x;
    const double energy = std::sqrt(std::max(0.0, size * dot(z, r, rows, threads)));
    if (result.iterations == 0) energy_at_start = best = energy;
    result.reduction = size / start;
    result.reached = energy <= goal.energy_reduction * energy_at_start;
    if (energy < best) {
      best = energy;
      best_at = result.iterations;
    }
    if (result.reached || !std::isfinite(energy) || result.iterations - best_at > goal.patience) break;

    const double along = result.iterations > 0 ? size * dot(z, kp, rows, threads) / curvature : 0;
    for_blocks(rows, threads, [&](Index, Index first, Index last) {
      for_numbers(first, last, [&](std::size_t row, int i) {
        p[row].at[i] = size * double(z[row].at[i]) - along * p[row].at[i];
      });
    });
    curvature = apply(level, p, kp, threads);
    if (!(curvature > 0)) break;
    const double step = dot(p, r, rows, threads) / curvature;
    for_blocks(rows, threads, [&](Index, Index first, Index last) {
      for_numbers(first, last, [&](std::size_t row, int i) {
        x[row].at[i] += step * p[row].at[i];
        r[row].at[i] -= step * kp[row].at[i];
      });
    });
    size = std::sqrt(dot(r, r, rows, threads));
    ++result.iterations;
    if (!(size > 0)) return {result.iterations, 0, size == 0};
  }
  return result;
}

template Convergence flexible_cg(Hierarchy<float>&, const Goal&, int, Rows<double>&, Rows<double>&);
template Convergence flexible_cg(Hierarchy<double>&, const Goal&, int, Rows<double>&, Rows<double>&);

}  // namespace bondstatic::multigrid
