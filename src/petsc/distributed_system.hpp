// K as PETSc's matrix, by rows over the ranks: each assembles the rows of its own bodies from
// its own links, and holds nothing of the size of the whole. All functions are called by all ranks.
#pragma once

#include <memory>

#include "bondstatic/linear_solver.hpp"
#include "petsc/handle.hpp"
#include "petsc/layout.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

class DistributedSystem {
 public:
  /// The pattern; no values yet. PETSc must have been started. Throws Error (invalid_input) where it is
  /// beyond PETSc's integers, and where several ranks run and this one holds no share.
  DistributedSystem(const BondNetwork& network, const FreeDofs& dofs);

  /// Takes the memory for the matrix at the first call: what it will be is known before.
  void assemble(const BondNetwork& network, const FreeDofs& dofs);

  Mat matrix() const { return matrix_; }
  /// Vectors of the matrix's layout, for right-hand sides, answers and residuals.
  PetscVector make_vector() const;

  /// The rigid modes, orthonormal, attached to the matrix as its near-null space: u = t + w x x, theta = w.
  void attach_rigid_modes(const BondNetwork& network);

  /// Zero where nothing is unknown. An iterative answer is not quite, as a preconditioner couples what the
  /// matrix does not.
  void clear_held(const FreeDofs& dofs, Vec vector) const;

  /// From the unknowns of own bodies. Nothing is asked of the values of copies.
  void scatter(const FreeDofs& dofs, Eigen::Ref<const Eigen::VectorXd> unknowns, Vec vector) const;
  /// To the unknowns of own bodies and of copies.
  void gather(const BondNetwork& network, const FreeDofs& dofs, Vec vector,
              Eigen::Ref<Eigen::VectorXd> unknowns) const;

  /// Unknowns and entries of K, of all ranks; what a method needs on top is the method's to fill in.
  AnalysisReport report(const BondNetwork& network, const FreeDofs& dofs) const;
  /// Of this rank's rows of K as PETSc stores them.
  double matrix_bytes() const;
  /// Sum over the ranks of this machine.
  double on_this_machine(double bytes) const;
  int ranks() const { return ranks_; }

 private:
  void take_rows_of_copies(Ranks& ranks, const BondNetwork& network, const FreeDofs& dofs);
  void allocate();

  int rank_ = 0, ranks_ = 1;
  Incidence incidence_;
  Layout layout_;
  Index rows_ = 0;                  ///< block rows of all ranks
  std::vector<BlockCount> counts_;  ///< of each block row of this rank
  Index blocks_ = 0;                ///< in them
  PetscMatrix matrix_;
};

}  // namespace bondstatic
