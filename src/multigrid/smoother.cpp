#include "multigrid/smoother.hpp"

#include "multigrid/block_loop.hpp"

namespace bondstatic::multigrid {

namespace {

// Chebyshev's semi-iteration (Saad, Iterative Methods for Sparse Linear Systems, Alg. 12.1) for eigenvalues
// in [lowest, 2], cut after two steps:
//
//     d = D^-1 r / centre,   r -= K d,   d' = rho' rho d + (2 rho' / half) D^-1 r,   x = d + d'.
//
// What lies below `lowest` is left to the clumps. Iterations hardly depend on it (measured from 0.15 to 0.6).
constexpr double lowest = 0.3;
constexpr double centre = (2 + lowest) / 2, half = (2 - lowest) / 2;
constexpr double rho = half / centre, next_rho = 1 / (2 / rho - rho);

template <class Scalar>
const InversePack<Scalar>* inverse_of(const Level<Scalar>& level, Index first) {
  return level.inverse.data() + first / pack_size;
}
std::size_t packs(Index first, Index last) {
  return std::size_t((last - first + pack_size - 1) / pack_size);
}

// d = D^-1 r / centre; x = d, or x += d.
template <class Scalar>
void first_step(Level<Scalar>& level, bool from_zero, int threads) {
  for_blocks(level.bodies, threads, [&](Index, Index first, Index last) {
    apply_inverse(inverse_of(level, first), packs(first, last), level.r[std::size_t(first)].at,
                  level.d[std::size_t(first)].at);
    for_numbers(first, last, [&](std::size_t row, int i) {
      const Scalar d = Scalar(1 / centre) * level.d[row].at[i];
      level.d[row].at[i] = d;
      level.x[row].at[i] = from_zero ? d : level.x[row].at[i] + d;
    });
  });
}

// r -= K d, e = d', x += e.
template <class Scalar>
void second_step(Level<Scalar>& level, int threads) {
  for_products(level, level.d, threads,
               [&](Index, Index first, Index last, Rows<Scalar>& kd, Rows<Scalar>& z) {
                 for_numbers(first, last, [&](std::size_t row, int i) {
                   Scalar& r = level.r[row].at[i];
                   r -= kd[row - std::size_t(first)].at[i];
                   kd[row - std::size_t(first)].at[i] = r;
                 });
                 apply_inverse(inverse_of(level, first), packs(first, last), kd.front().at, z.front().at);
                 for_numbers(first, last, [&](std::size_t row, int i) {
                   const Scalar e = Scalar(next_rho * rho) * level.d[row].at[i] +
                                    Scalar(2 * next_rho / half) * z[row - std::size_t(first)].at[i];
                   level.e[row].at[i] = e;
                   level.x[row].at[i] += e;
                 });
               });
}

// r -= K e.
template <class Scalar>
void subtract_product(Level<Scalar>& level, int threads) {
  for_products(level, level.e, threads, [&](Index, Index first, Index last, Rows<Scalar>& ke, Rows<Scalar>&) {
    for_numbers(first, last,
                [&](std::size_t row, int i) { level.r[row].at[i] -= ke[row - std::size_t(first)].at[i]; });
  });
}

}  // namespace

template <class Scalar>
void smooth_from_zero(Level<Scalar>& level, int threads) {
  first_step(level, true, threads);
  second_step(level, threads);
  subtract_product(level, threads);
}

template <class Scalar>
void smooth_after_step(Level<Scalar>& level, int threads) {
  subtract_product(level, threads);
  first_step(level, false, threads);
  second_step(level, threads);
}

template void smooth_from_zero(Level<float>&, int);
template void smooth_from_zero(Level<double>&, int);
template void smooth_after_step(Level<float>&, int);
template void smooth_after_step(Level<double>&, int);

}  // namespace bondstatic::multigrid
