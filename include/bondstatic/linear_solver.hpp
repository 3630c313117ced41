// The contract of a linear solver: analyse the pattern, factorise the values (or set up a preconditioner from
// them), solve. A backend is one file or one folder; the unknowns are those of FreeDofs with rotations
// multiplied by network.rotation_length, so that the matrix is well scaled in any unit system.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bondstatic/network.hpp"

namespace bondstatic {

struct AnalysisReport {
  Index unknowns = 0;
  Index matrix_entries = 0;  ///< lower triangle, without fill
  Index factor_entries = 0;  ///< as stored
  double factor_flops = 0;
  double predicted_bytes = 0;  ///< peak of the whole solve, what stands in memory already not counted
  std::string ordering;        ///< "METIS on particles", ...
};

struct FactorReport {
  /// Smallest ratio of a pivot to the diagonal entry it came from: near rounding where the matrix is
  /// numerically singular. Zero where the factorisation broke down; then `broken_at` is the unknown where it
  /// did, or -1 where the solver cannot tell. 1 where it does not know its pivots.
  double pivot_ratio = 1;
  Index broken_at = -1;
};

/// What the last solve() of an iterative solver did, worst column.
struct SolveReport {
  int iterations = 0;
  double reduction = 0;  ///< |residual| after over before, 2-norm
  bool reached = true;   ///< false where it gave up: what it returns may still be a step forward
  std::string note;      ///< what a user should hear, such as a change of precision; "" for nothing
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Order and analyse the pattern of K. To be called again only where links or free dofs change.
  virtual AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) = 0;

  /// Assemble and factorise; the pattern is that of the last analyse(), the stiffness may have changed. Both
  /// arguments must last as long as solve() is called.
  virtual FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) = 0;

  /// Solve for all columns at once; rows are unknowns. An iterative solver stops where it has reduced the
  /// residual by several decades; the caller forms the true residual and comes back with it, so a solve that
  /// stops early or says too much costs time, never accuracy.
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) = 0;

  /// solve() in two halves, where K = L L^T in some order of the unknowns: L^-1 b, and L^-T y back in theirs.
  /// Unknowns that b does not reach stay exactly zero, and cost nothing. Corrections of low rank live on
  /// them.
  virtual bool has_halves() const { return false; }
  virtual Eigen::MatrixXd forward(const Eigen::MatrixXd& b) { return no_halves(b); }
  virtual Eigen::MatrixXd backward(Eigen::MatrixXd y) { return no_halves(y); }

  virtual bool iterative() const { return false; }
  virtual SolveReport last_solve() const { return {}; }

 private:
  [[noreturn]] static Eigen::MatrixXd no_halves(const Eigen::MatrixXd&) {
    throw std::logic_error("this solver has no halves");
  }
};

struct SolverInfo {
  std::string name;
  std::string description;
  bool on_ranks = false;  ///< may run as several processes under an MPI launcher
};

/// The solvers of this build, best first.
std::vector<SolverInfo> available_solvers();

/// `name` from available_solvers(), or "auto" for the first. `threads` holds for everything the solver runs,
/// BLAS included; `backend_options` are handed on to a backend that takes its own (PETSc). Throws Error
/// (invalid_input) that lists the names of this build for an unknown one, and for options that nobody takes.
std::unique_ptr<LinearSolver> make_solver(const std::string& name, int threads,
                                          const std::vector<std::string>& backend_options = {});

}  // namespace bondstatic
