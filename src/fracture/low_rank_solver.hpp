// Links taken out of K, and bodies pinned, on the factor of K as it was (M. A. Woodbury, Memorandum Report
// 42, Statistical Research Group, Princeton 1950). A link's part of K has rank 6 at most, B^T C B = G G^T, so
// with all changes side by side in W and their signs in S = diag(-1 taken out, +1 pinned)
//
//     K' = K + W S W^T,     K'^-1 = L^-T (I - Y (S + Y^T Y)^-1 Y^T) L^-1,     K = L L^T,  Y = L^-1 W.
//
// A link touches two bodies, so its columns of Y are zero but for the path of these through the elimination
// tree, a small part of them: the rows that are not are all that is kept. S + Y^T Y = T S T^T is extended as
// changes come; every intermediate K' is positive definite, so no pivoting is needed, and the squares of T's
// diagonal are what is left of each direction's stiffness: near zero, the link was all that held something.
#pragma once

#include <memory>
#include <vector>

#include "bondstatic/linear_solver.hpp"

namespace bondstatic {

class LowRankSolver final : public LinearSolver {
 public:
  /// `whole`: a direct solver that has halves.
  explicit LowRankSolver(std::unique_ptr<LinearSolver> whole) : whole_(std::move(whole)) {}

  /// These two are `whole`'s; all changes are forgotten.
  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override;
  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override;

  /// Rows are those of the dofs that were given last, by analyse() or keep_only().
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override;

  /// From here on some bodies' unknowns are none: a part of the dofs that were analysed.
  void keep_only(FreeDofs dofs) { dofs_ = std::move(dofs); }

  /// Springs of this stiffness to the ground on all unknowns of a body, among those analysed.
  void pin(Index body, double stiffness);

  /// Takes links out, each with the stiffness that it has in K. Returns the smallest part of its own
  /// stiffness in any direction that the rest still has, 0 where nothing was left; then, or where it is below
  /// `least`, nothing has changed.
  double take_out(const std::vector<Link>& links, double least);

  /// Of a body, in the factor.
  Index unknowns_of(Index body) const {
    return factored_.first[std::size_t(body) + 1] - factored_.first[std::size_t(body)];
  }

  Index rank() const { return Index(sign_.size()); }

  /// What the unknowns move by when the links that were taken out last let go, deformed as they are: K'^-1
  /// B^T C delta. Row i of `deltas` is each link's delta in case i.
  Eigen::MatrixXd let_go(const std::vector<std::vector<Vector6>>& deltas);

 private:
  struct Entry {
    Index unknown;
    double value;
  };
  using Column = std::vector<Entry>;  // of W: twelve entries at most

  struct Columns {
    std::vector<Column> of_w;
    std::vector<std::pair<std::size_t, Vector6>> parts;  // which link, and the g with C = sum g g^T
  };
  struct Block {  // of Y
    std::vector<Index> rows;
    Eigen::MatrixXd values;
    Index first;  // of its columns
  };

  Columns columns_of(const std::vector<Link>& links) const;
  double append(const std::vector<Column>& columns, double sign, double least);
  Eigen::MatrixXd against_blocks(const Eigen::MatrixXd& y) const;
  Eigen::MatrixXd corrected(Eigen::MatrixXd y);
  Eigen::MatrixXd expanded(const Eigen::MatrixXd& kept) const;
  Eigen::MatrixXd kept_rows(Eigen::MatrixXd all) const;

  std::unique_ptr<LinearSolver> whole_;
  FreeDofs factored_;  // of the factor
  FreeDofs dofs_;      // of solve()
  double length_ = 1;
  std::vector<Block> blocks_;
  Eigen::VectorXd sign_;
  Eigen::MatrixXd lower_;  // T, rows and columns beyond rank() are spare
  std::vector<std::pair<std::size_t, Vector6>> last_parts_;
};

}  // namespace bondstatic
