// MUMPS by PETSc: multifrontal L D L^T without pivoting, over all ranks. L D L^T rather than L L^T, as MUMPS
// counts negative pivots only there.
#include <fmt/format.h>

#include <optional>

#include "bondstatic/error.hpp"
#include "petsc/backends.hpp"
#include "petsc/distributed_system.hpp"
#include "petsc/session.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

// INFOG numbers of the MUMPS users' guide.
constexpr PetscInt status = 1, megabytes_in_all = 17, negative_pivots = 12, predicted_entries = 20;
constexpr PetscInt predicted_flops = 1;        // of RINFOG
constexpr PetscInt threshold_of_pivoting = 1;  // of CNTL
constexpr PetscInt working_space = 14;         // of ICNTL: per cent more than estimated
constexpr PetscInt no_memory = -13;            // of INFOG(1): the system gave none
constexpr PetscInt room_to_begin_with = 30, most_room = 300;

class Direct final : public LinearSolver {
 public:
  Direct(int threads, const std::vector<std::string>& options) : threads_(threads), options_(options) {
    start_petsc(options_);
  }

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override {
    const SolverThreads guard(threads_);
    system_.emplace(network, dofs);
    dofs_ = dofs;
    // The values are not looked at, but PETSc analyses assembled matrices only.
    system_->assemble(network, dofs);
    analyse_with(room_to_begin_with);
    AnalysisReport report = system_->report(network, dofs);
    report.ordering += ", ordered by MUMPS's choice";
    report.factor_entries = information(predicted_entries);
    if (report.factor_entries < 0) report.factor_entries *= -1'000'000;  // told in millions
    check_petsc(MatMumpsGetRinfog(factor_, predicted_flops, &report.factor_flops));
    // Measured: a sixth of MUMPS's own figure is slack that it sets aside and does not touch. Beside it stand
    // its copy of the lower triangle as triples, the matrix, and what refinement keeps.
    report.predicted_bytes =
        0.84e6 * double(information(megabytes_in_all)) +
        system_->on_this_machine(1.7 * system_->matrix_bytes() + 96.0 * double(network.links.size()) +
                                 4 * 96.0 * double(network.bodies));
    return report;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    const SolverThreads guard(threads_);
    network_ = &network;
    system_->assemble(network, dofs);
    MatFactorError failure = MAT_FACTOR_NOERROR;
    for (PetscInt room = room_to_begin_with;; room *= 3) {
      check_petsc(MatCholeskyFactorNumeric(factor_, system_->matrix(), &info_));
      check_petsc(MatFactorGetError(factor_, &failure));
      if (failure != MAT_FACTOR_OUTMEMORY) break;
      if (information(status) == no_memory || room > most_room)
        throw MemoryError(
            fmt::format("MUMPS ran out of memory in the factorisation (INFOG(1) = {}, INFOG(2) = {})"
                        "\n    cure: use the solver petsc, or more ranks on more machines",
                        information(status), information(status + 1)));
      // Its own estimate fell short: not the machine's memory but the part of it that MUMPS had set aside.
      analyse_with(3 * room);
    }
    refuse_unused(options_);
    if (failure != MAT_FACTOR_NOERROR || information(negative_pivots) > 0) return {0, -1};
    return {};
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    const SolverThreads guard(threads_);
    Eigen::MatrixXd answer(right_hand_sides.rows(), right_hand_sides.cols());
    const PetscVector b = system_->make_vector(), x = system_->make_vector();
    for (Index c = 0; c < answer.cols(); ++c) {
      system_->scatter(dofs_, right_hand_sides.col(c), b);
      check_petsc(MatSolve(factor_, b, x));
      system_->gather(*network_, dofs_, x, answer.col(c));
    }
    return answer;
  }

 private:
  void analyse_with(PetscInt room) {
    check_petsc(MatGetFactor(system_->matrix(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.fresh()));
    check_petsc(MatMumpsSetCntl(factor_, threshold_of_pivoting, 0));
    check_petsc(MatMumpsSetIcntl(factor_, working_space, room));
    check_petsc(MatFactorInfoInitialize(&info_));
    check_petsc(MatCholeskyFactorSymbolic(factor_, system_->matrix(), nullptr, &info_));
  }

  Index information(PetscInt number) const {
    PetscInt value = 0;
    check_petsc(MatMumpsGetInfog(factor_, number, &value));
    return value;
  }

  int threads_;
  std::vector<std::string> options_;
  FreeDofs dofs_;
  const BondNetwork* network_ = nullptr;  // of the last factorise()
  std::optional<DistributedSystem> system_;
  PetscMatrix factor_;
  MatFactorInfo info_{};
};

}  // namespace

std::unique_ptr<LinearSolver> make_petsc_direct(int threads, const std::vector<std::string>& options) {
  return std::make_unique<Direct>(threads, options);
}

}  // namespace bondstatic
