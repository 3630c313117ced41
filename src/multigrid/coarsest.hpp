// The coarsest level, small enough to be solved at once.
#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "multigrid/level.hpp"

namespace bondstatic::multigrid {

class Coarsest {
 public:
  /// Assembles and factorises in double. Springs count where no body is partly held (see finest_packing).
  template <class LinkType>
  void factorise(const Packing<LinkType>& packing, const Numbering& numbering,
                 const std::vector<PartlyHeld>& partly_held);

  /// False where K is indefinite, by nature or by the rounding of what it was formed from.
  bool positive() const { return (factor_->vectorD().array() > 0).all(); }

  template <class Scalar>
  void solve(const Rows<Scalar>& r, Rows<Scalar>& x) const {
    Eigen::VectorXd b(unknowns_);
    for (Index i = 0; i < unknowns_; ++i) b[i] = double(r[std::size_t(i / 6)].at[i % 6]);
    b = factor_->solve(b).eval();
    for (Index i = 0; i < unknowns_; ++i) x[std::size_t(i / 6)].at[i % 6] = Scalar(b[i]);
  }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
  using Triplets = std::vector<Eigen::Triplet<double, Index>>;
  void factorise(const Triplets& entries);

  Index unknowns_ = 0;
  std::unique_ptr<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<Index>>> factor_;
};

}  // namespace bondstatic::multigrid
