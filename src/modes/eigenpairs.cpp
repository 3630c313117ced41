#include "modes/eigenpairs.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "modes/lanczos.hpp"

namespace bondstatic {

namespace {

constexpr double lanczos_tolerance = 1e-11;  // residual over eigenvalue
constexpr Index most_restarts = 200;

Index subspace_of(Index count) {
  return 2 * count + 20;
}

EigenPairs lanczos_eigenpairs(Index n, const Operator& apply, Index count, double scale) {
  ScaledOperator scaled{n, apply, 1 / scale};
  for (Index subspace = subspace_of(count);; subspace *= 2) {
    Lanczos lanczos(scaled, count, std::min(subspace, n));
    if (lanczos.run(most_restarts, lanczos_tolerance))
      return {scale * lanczos.eigenvalues(), lanczos.eigenvectors()};
    if (subspace >= n || subspace >= 8 * subspace_of(count))
      throw AccuracyError(fmt::format(
          "{} modes of {} unknowns did not converge: {} restarts of Lanczos with {} vectors\n    cure: ask "
          "for another number of modes, so that the last is apart from the next, or look for groups that "
          "hang by bonds many decades softer than the rest",
          count, n, most_restarts, std::min(subspace, n)));
  }
}

// Puts a pair in its place and drops the last.
void insert(EigenPairs& pairs, double value, const Eigen::VectorXd& vector) {
  Index at = pairs.values.size() - 1;
  for (; at > 0 && pairs.values[at - 1] < value; --at) {
    pairs.values[at] = pairs.values[at - 1];
    pairs.vectors.col(at) = pairs.vectors.col(at - 1);
  }
  pairs.values[at] = value;
  pairs.vectors.col(at) = vector;
}

}  // namespace

EigenPairs largest_eigenpairs(Index n, const Operator& apply, Index count) {
  const SerialProducts serial;
  const double scale = typical_value(n, apply);
  if (n <= dense_up_to || n <= subspace_of(count) || !(scale > 0)) return dense_eigenpairs(n, apply, count);
  EigenPairs found = lanczos_eigenpairs(n, apply, count, scale);

  // One start vector sees one mode of each multiple frequency, and the others only by rounding: what is
  // orthogonal to the modes found must hold none that comes before the last of them.
  Eigen::VectorXd x(n);
  const auto project = [&found](Eigen::Ref<Eigen::VectorXd> v) {
    v -= found.vectors * (found.vectors.transpose() * v).eval();
  };
  const Operator rest = [&](const double* in, double* out) {
    x = Eigen::Map<const Eigen::VectorXd>(in, n);
    project(x);
    apply(x.data(), out);
    project(Eigen::Map<Eigen::VectorXd>(out, n));
  };
  for (;;) {
    const double last = found.values[count - 1];
    const EigenPairs next = lanczos_eigenpairs(n, rest, 1, last);
    if (next.values[0] <= last * (1 + 1e-9)) return found;
    Eigen::VectorXd vector = next.vectors.col(0);
    project(vector);
    insert(found, next.values[0], vector.normalized());
  }
}

}  // namespace bondstatic
