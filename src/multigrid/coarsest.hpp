// The coarsest level, small enough to be solved at once; by all ranks the same, where there are several.
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
  void factorise(const Packing<LinkType>& packing, const Numbering& numbering, const Halo& rows,
                 const std::vector<PartlyHeld>& partly_held);

  /// False where K is indefinite, by nature or by the rounding of what it was formed from.
  bool positive() const { return (factor_->vectorD().array() > 0).all(); }

  /// `rows` of r are this rank's, as are those of x.
  template <class Scalar>
  void solve(const Halo& halo, Index rows, const Rows<Scalar>& r, Rows<Scalar>& x) const {
    Eigen::VectorXd mine(6 * rows);
    for (Index i = 0; i < mine.size(); ++i) mine[i] = double(r[std::size_t(i / 6)].at[i % 6]);
    const Eigen::VectorXd answer = factor_->solve(of_all(halo, mine));
    for (Index i = 0; i < mine.size(); ++i)
      x[std::size_t(i / 6)].at[i % 6] = Scalar(answer[6 * first_row_ + i]);
  }

 private:
  Eigen::VectorXd of_all(const Halo& halo, const Eigen::VectorXd& mine) const;
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
  using Triplets = std::vector<Eigen::Triplet<double, Index>>;
  void factorise(const Triplets& entries);
  void number_rows(const Halo& halo, Index own);

  Index unknowns_ = 0;          ///< of all ranks
  Index first_row_ = 0;         ///< of this rank, among those of all
  std::vector<Index> rows_of_;  ///< of each rank
  std::unique_ptr<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<Index>>> factor_;
};

}  // namespace bondstatic::multigrid
