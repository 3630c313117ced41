// CG with PETSc's algebraic multigrid (GAMG, smoothed aggregation), whose coarse spaces are made of the six
// rigid modes. Any other Krylov method and preconditioner of PETSc by its own options.
#include <fmt/format.h>

#include <optional>

#include "bondstatic/error.hpp"
#include "petsc/backends.hpp"
#include "petsc/distributed_system.hpp"
#include "petsc/session.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

constexpr double relative_tolerance = 1e-8;
constexpr PetscInt most_iterations = 2000;
// CG's own residual drifts from the true one; where it did, it is begun anew from the true one.
constexpr int most_restarts = 3;

class Iterative final : public LinearSolver {
 public:
  Iterative(int threads, const std::vector<std::string>& options) : threads_(threads), options_(options) {
    start_petsc(options_);
  }

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override {
    krylov_.fresh();
    system_.emplace(network, dofs);
    dofs_ = dofs;
    AnalysisReport report = system_->report(network, dofs);
    // Measured on disordered FCC of 7, 16 and 32 thousand particles: matrix, coarse matrices, interpolations
    // and smoothers together take 2.0 to 2.1 times the matrix at their peak. On several ranks PETSc's
    // products of distributed matrices keep what they pass through: 3.7 and 4.9 times on two packings.
    const double times = system_->ranks() > 1 ? 4.3 : 2.1;
    report.predicted_bytes =
        system_->on_this_machine(times * system_->matrix_bytes() + 96.0 * double(network.links.size()) +
                                 8 * 48.0 * double(network.bodies));
    return report;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    const SolverThreads guard(threads_);
    network_ = &network;
    system_->assemble(network, dofs);
    system_->attach_rigid_modes(network);
    check_petsc(MatSetOption(system_->matrix(), MAT_SPD, PETSC_TRUE));
    if (!krylov_) configure();
    check_petsc(KSPSetOperators(krylov_, system_->matrix(), system_->matrix()));
    check_petsc(KSPSetUp(krylov_));
    return {};
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    const SolverThreads guard(threads_);
    report_ = {};
    Eigen::MatrixXd answer(right_hand_sides.rows(), right_hand_sides.cols());
    for (Index c = 0; c < answer.cols(); ++c) solve_column(right_hand_sides.col(c), answer.col(c));
    refuse_unused(options_);
    return answer;
  }

  bool iterative() const override { return true; }
  SolveReport last_solve() const override { return report_; }

 private:
  void configure() {
    check_petsc(KSPCreate(PETSC_COMM_WORLD, krylov_.fresh()));
    check_petsc(KSPSetType(krylov_, KSPCG));
    check_petsc(KSPSetNormType(krylov_, KSP_NORM_UNPRECONDITIONED));
    check_petsc(KSPSetTolerances(krylov_, relative_tolerance, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations));
    PC preconditioner = nullptr;
    check_petsc(KSPGetPC(krylov_, &preconditioner));
    check_petsc(PCSetType(preconditioner, PCGAMG));
    check_petsc(KSPSetFromOptions(krylov_));
  }

  void solve_column(Eigen::Ref<const Eigen::VectorXd> given, Eigen::Ref<Eigen::VectorXd> answer) {
    const PetscVector b = system_->make_vector(), r = system_->make_vector(), x = system_->make_vector(),
                      step = system_->make_vector();
    system_->scatter(dofs_, given, b);
    check_petsc(VecCopy(b, r));
    check_petsc(VecSet(x, 0));
    PetscReal before = 0, tolerance = 0, left = 1;
    check_petsc(VecNorm(b, NORM_2, &before));
    check_petsc(KSPGetTolerances(krylov_, &tolerance, nullptr, nullptr, nullptr));
    int iterations = 0;
    std::string note;
    for (int restart = 0; before > 0 && left > tolerance && restart <= most_restarts; ++restart) {
      check_petsc(KSPSolve(krylov_, r, step));
      PetscInt count = 0;
      KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
      check_petsc(KSPGetIterationNumber(krylov_, &count));
      check_petsc(KSPGetConvergedReason(krylov_, &reason));
      iterations += int(count);
      if (reason < 0) note = fmt::format("gave up: {}", KSPConvergedReasons[reason]);
      system_->clear_held(dofs_, step);
      // What this solve says of itself counts for nothing: b - A x does.
      check_petsc(VecAXPY(step, 1, x));
      check_petsc(MatMult(system_->matrix(), step, r));
      check_petsc(VecAYPX(r, -1, b));
      PetscReal after = 0;
      check_petsc(VecNorm(r, NORM_2, &after));
      if (!(after < left * before)) break;  // no step forward; NaN neither
      check_petsc(VecCopy(step, x));
      left = after / before;
      if (reason < 0) break;
    }
    system_->gather(*network_, dofs_, x, answer);
    if (before == 0) left = 0;
    const bool reached = left <= tolerance;
    report_.iterations = std::max(report_.iterations, iterations);
    report_.reduction = std::max(report_.reduction, left);
    report_.reached = report_.reached && reached;
    if (!reached && report_.note.empty()) report_.note = note;
  }

  int threads_;
  std::vector<std::string> options_;
  FreeDofs dofs_;
  const BondNetwork* network_ = nullptr;  // of the last factorise()
  std::optional<DistributedSystem> system_;
  PetscKrylov krylov_;
  SolveReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_petsc_iterative(int threads, const std::vector<std::string>& options) {
  return std::make_unique<Iterative>(threads, options);
}

}  // namespace bondstatic
