// What a supernodal factor of CHOLMOD tells of itself.
#pragma once

#include <cholmod.h>

#include "system/assemble.hpp"

namespace bondstatic {

/// Bytes of the factor, once it has values, and of the workspace that its numerical factorisation takes.
double factor_bytes(const cholmod_factor& factor);

/// Smallest ratio of a pivot to the diagonal entry of `k` (lower triangle) that it came from.
double pivot_ratio(const cholmod_factor& factor, const SparseMatrix& k);

}  // namespace bondstatic
