#include "modes/lanczos.hpp"

#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

Eigen::VectorXd start_vector(Index n) {
  Eigen::VectorXd start(n);
  for (Index i = 0; i < n; ++i) {
    std::uint64_t bits = (std::uint64_t(i) + 1) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    const double size = 0.5 + double(bits >> 11) * 0x1p-53;
    start[i] = bits & 1 ? size : -size;
  }
  return start;
}

double typical_value(Index n, const Operator& apply) {
  const Eigen::VectorXd start = start_vector(n).normalized();
  Eigen::VectorXd product(n);
  apply(start.data(), product.data());
  const double size = product.norm();
  if (!std::isfinite(size))
    throw AccuracyError(
        "stiffness over mass is not finite: there are no frequencies\n    cure: look for bonds or "
        "masses many decades from the rest");
  return size;
}

EigenPairs dense_eigenpairs(Index n, const Operator& apply, Index count) {
  Eigen::MatrixXd a(n, n);
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    unit[i] = 1;
    apply(unit.data(), a.col(i).data());
    unit[i] = 0;
  }
  const Eigen::MatrixXd symmetric = (a + a.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(symmetric);
  return {all.eigenvalues().tail(count).reverse(), all.eigenvectors().rightCols(count).rowwise().reverse()};
}

}  // namespace bondstatic
