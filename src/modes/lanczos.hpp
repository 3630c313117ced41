// Lanczos with implicit restarts on an operator scaled to eigenvalues near one, from a fixed start.
#pragma once

#include <Spectra/SymEigsSolver.h>
#include <omp.h>

#include <Eigen/Eigenvalues>

#include "modes/eigenpairs.hpp"

namespace bondstatic {

// Below this a dense solve costs nothing, and Lanczos could run out of directions.
constexpr Index dense_up_to = 200;

// Eigen shares large products out to OpenMP's threads, in blocks that depend on their number.
class SerialProducts {
 public:
  SerialProducts() : before_(omp_get_max_threads()) { omp_set_num_threads(1); }
  ~SerialProducts() { omp_set_num_threads(before_); }
  SerialProducts(const SerialProducts&) = delete;
  SerialProducts& operator=(const SerialProducts&) = delete;

 private:
  int before_;
};

/// Without any pattern: no mode of a symmetric body, and no mode of a single particle, is orthogonal to it.
Eigen::VectorXd start_vector(Index n);

/// |A x| of the start vector: a typical eigenvalue. Zero for A = 0. Throws AccuracyError where not finite.
double typical_value(Index n, const Operator& apply);

/// The `count` largest by a dense solve.
EigenPairs dense_eigenpairs(Index n, const Operator& apply, Index count);

// Spectra compares with absolute thresholds: eigenvalues are brought near one.
struct ScaledOperator {
  using Scalar = double;
  Index n;
  const Operator& apply;
  double factor;

  Index rows() const { return n; }
  Index cols() const { return n; }
  void perform_op(const double* x, double* y) const {
    apply(x, y);
    Eigen::Map<Eigen::VectorXd>(y, n) *= factor;
  }
};

class Lanczos : public Spectra::SymEigsSolver<ScaledOperator> {
 public:
  using SymEigsSolver::SymEigsSolver;

  bool run(Eigen::Index most_restarts, double tolerance) {
    init(start_vector(m_n).data());
    compute(Spectra::SortRule::LargestAlge, most_restarts, tolerance, Spectra::SortRule::LargestAlge);
    return info() == Spectra::CompInfo::Successful;
  }

  // Best vector of the subspace, converged or not.
  Eigen::VectorXd leading() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(m_fac.matrix_H());
    return m_fac.matrix_V() * small.eigenvectors().rightCols<1>();
  }
};

}  // namespace bondstatic
