#include "multigrid/transfer.hpp"

#include "multigrid/block_loop.hpp"

namespace bondstatic::multigrid {

template <class Scalar>
void gather_on_clumps(Level<Scalar>& fine, Level<Scalar>& coarse, int threads) {
  leave_out_held(fine, fine.r);
  for_blocks(coarse.bodies, threads, [&](Index, Index first, Index last) {
    for (Index clump = first; clump < last; ++clump) {
      double sum[6] = {};
      const Index end = fine.clump_first[std::size_t(clump) + 1];
      for (Index row = fine.clump_first[std::size_t(clump)]; row < end; ++row) {
        const Scalar* f = fine.r[std::size_t(row)].at;
        const auto& at = fine.offset[std::size_t(row)];
        for (int i = 0; i < 6; ++i) sum[i] += double(f[i]);
        sum[3] += double(at[1] * f[2] - at[2] * f[1]);
        sum[4] += double(at[2] * f[0] - at[0] * f[2]);
        sum[5] += double(at[0] * f[1] - at[1] * f[0]);
      }
      for (int i = 0; i < 6; ++i) coarse.r[std::size_t(clump)].at[i] = Scalar(sum[i]);
    }
  });
}

template <class Scalar>
void move_with_clumps(const Level<Scalar>& coarse, Level<Scalar>& fine, double factor, int threads) {
  for_blocks(coarse.bodies, threads, [&](Index, Index first, Index last) {
    for (Index clump = first; clump < last; ++clump) {
      Scalar u[6];
      for (int i = 0; i < 6; ++i) u[i] = Scalar(factor) * coarse.x[std::size_t(clump)].at[i];
      const Index end = fine.clump_first[std::size_t(clump) + 1];
      for (Index row = fine.clump_first[std::size_t(clump)]; row < end; ++row) {
        const auto& at = fine.offset[std::size_t(row)];
        Scalar* to = fine.e[std::size_t(row)].at;
        to[0] = u[0] + u[4] * at[2] - u[5] * at[1];
        to[1] = u[1] + u[5] * at[0] - u[3] * at[2];
        to[2] = u[2] + u[3] * at[1] - u[4] * at[0];
        for (int i = 3; i < 6; ++i) to[i] = u[i];
      }
    }
  });
  const Index in_clumps = fine.clump_first.back();
  std::fill(fine.e.begin() + in_clumps, fine.e.begin() + fine.bodies, Row<Scalar>{});
  leave_out_held(fine, fine.e);
  for_blocks(fine.bodies, threads, [&](Index, Index first, Index last) {
    for_numbers(first, last, [&](std::size_t row, int i) { fine.x[row].at[i] += fine.e[row].at[i]; });
  });
}

template void gather_on_clumps(Level<float>&, Level<float>&, int);
template void gather_on_clumps(Level<double>&, Level<double>&, int);
template void move_with_clumps(const Level<float>&, Level<float>&, double, int);
template void move_with_clumps(const Level<double>&, Level<double>&, double, int);

}  // namespace bondstatic::multigrid
