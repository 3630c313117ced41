// D^-1: the inverses of the 6x6 diagonal blocks, which smooth on every level.
#pragma once

#include <cstddef>

#include "multigrid/lanes.hpp"
#include "multigrid/packing.hpp"

namespace bondstatic::multigrid {

/// Inverses of eight bodies' blocks, the upper triangle row by row; zero in lanes without a body.
template <class Scalar>
struct InversePack {
  Scalar c[21][pack_size] = {};
};

/// The inverse of a symmetric positive semi-definite block. Rows and columns of degrees of freedom that are
/// not in `free` are zero, and motions that cost nothing but rounding are left out.
Matrix6 inverse_block(const Matrix6& block, std::uint8_t free);

/// z = D^-1 r of the bodies of so many packs; vectors have `stride` numbers a body and room for whole packs.
void apply_inverse(const InversePack<float>* packs, std::size_t count, const float* r, float* z);
void apply_inverse(const InversePack<double>* packs, std::size_t count, const double* r, double* z);

}  // namespace bondstatic::multigrid
