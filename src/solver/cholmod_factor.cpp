#include "solver/cholmod_factor.hpp"

#include <algorithm>

namespace bondstatic {

double factor_bytes(const cholmod_factor& factor) {
  // Values, row lists, first column and positions of each supernode, permutation and column counts; the
  // update that a supernode takes from one descendant, and five lists of the columns.
  return 8.0 * (double(factor.xsize) + double(factor.ssize) + 3 * double(factor.nsuper) +
                2 * double(factor.n) + double(factor.maxcsize) + 5 * double(factor.n));
}

double pivot_ratio(const cholmod_factor& factor, const SparseMatrix& k) {
  const auto* super = static_cast<const Index*>(factor.super);
  const auto* rows_at = static_cast<const Index*>(factor.pi);
  const auto* values_at = static_cast<const Index*>(factor.px);
  const auto* values = static_cast<const double*>(factor.x);
  const auto* permutation = static_cast<const Index*>(factor.Perm);
  double smallest = 1;
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const Index rows = rows_at[s + 1] - rows_at[s];
    for (Index j = 0; j < super[s + 1] - super[s]; ++j) {
      const double pivot = values[values_at[s] + j * (rows + 1)];
      const Index column = permutation[super[s] + j];
      // The diagonal entry is the first of its column in the lower triangle.
      smallest = std::min(smallest, pivot * pivot / k.valuePtr()[k.outerIndexPtr()[column]]);
    }
  }
  return smallest;
}

}  // namespace bondstatic
