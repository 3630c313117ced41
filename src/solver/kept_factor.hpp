// A direct solver that answers for stiffness not far from what it factorised last, on that factor.
//
// K is linear in each bond's C, so that where delta . C' delta over delta . C delta lies in [alpha, beta] for
// every bond and every motion delta, u . K' u over u . K u does, too. Conjugate gradients on K', with the
// factor of K as preconditioner, then take no more iterations than
//
//     error <= 2 ((sqrt(k) - 1) / (sqrt(k) + 1))^n,   k = beta / alpha
//
// tells beforehand (G. H. Golub & C. F. Van Loan, Matrix Computations, 4th ed., 11.3): one where all bonds
// change alike. Where they nearly do, 2 / (alpha + beta) times the factor's own answer is good to (k - 1) /
// (k + 1), and no product with K' is needed. Whether iterations are less than a factorisation is decided by
// counts, never by the clock, so that runs repeat.
#pragma once

#include <memory>
#include <optional>

#include "bondstatic/linear_solver.hpp"
#include "solver/cost_model.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

/// By how much stiffness changed: the least and the largest of all bonds' ratios of new to old.
struct StiffnessChange {
  double least = 1;
  double most = 1;
  double spread() const { return most / least; }
};

/// Nothing where ratios have no bounds: a stiffness came or went.
std::optional<StiffnessChange> stiffness_change(const std::vector<SectionStiffness>& before,
                                                const std::vector<Link>& now);

/// Iterations that bring the error, in the norm of the energy, to `reduction` of what it was.
int iterations_for(double spread, double reduction);

class KeptFactor final : public LinearSolver {
 public:
  /// `direct` has analysed the network, with that report and at those rates.
  KeptFactor(std::unique_ptr<LinearSolver> direct, const AnalysisReport& analysis, const DirectRates& rates,
             int threads);

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override;
  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override;
  /// On its own factor to rounding, else to five digits: refinement asks for the next ones where it needs
  /// them.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override;

  /// Iterations of the last solve(): 0 on its own factor.
  SolveReport last_solve() const override { return {iterations_, 0, true, {}}; }

  /// Of the last factorise(): the change since the factor was made; nothing where it made one.
  const std::optional<StiffnessChange>& kept() const { return kept_; }

 private:
  FactorReport factorise_anew(const BondNetwork& network, const FreeDofs& dofs);
  bool worth_keeping(const StiffnessChange& change, const BondNetwork& network) const;
  Eigen::MatrixXd product(const Eigen::MatrixXd& motions) const;

  std::unique_ptr<LinearSolver> direct_;
  AnalysisReport analysis_;
  DirectRates rates_;
  int threads_;
  Incidence incidence_;
  std::vector<SectionStiffness> factorised_;  // of each link; empty where there is no factor
  FactorReport factor_;
  std::optional<StiffnessChange> kept_;
  const BondNetwork* network_ = nullptr;
  const FreeDofs* dofs_ = nullptr;
  int iterations_ = 0;
};

}  // namespace bondstatic
