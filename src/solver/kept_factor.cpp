#include "solver/kept_factor.hpp"

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "solver/cost_model.hpp"
#include "system/natural_form.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

// Little is asked of a solve: the rounds of refinement, which form residuals anew, then end where they have
// enough, and not up to a whole solve later.
constexpr double reduction = 0x1p-18;

// What refinement asks of the state and of its derivatives, which begin from those of numbers close by, and
// the solves that it takes for both with a factor of their own. The number of threads has no say, so that
// answers do not depend on it.
constexpr double enough = 0x1p-84;
constexpr int solves_of_its_own = 4;

/// Takes the ratio of one stiffness, zero on both sides where there is none. False: it came or went.
bool take(double before, double now, StiffnessChange& change) {
  if (before == 0 && now == 0) return true;
  if (!(before > 0) || !(now > 0)) return false;
  change.least = std::min(change.least, now / before);
  change.most = std::max(change.most, now / before);
  return true;
}

/// Shear and bending where they are coupled: eigenvalues of the pencil of (ks, c; c, kb).
bool take_coupled(const SectionStiffness& before, const SectionStiffness& now, StiffnessChange& change) {
  const double det = before.ks * before.kb - before.coupling * before.coupling;
  const double det_now = now.ks * now.kb - now.coupling * now.coupling;
  if (!(det > 0) || !(det_now > 0)) return false;
  const double mean =
      (now.ks * before.kb + now.kb * before.ks - 2 * now.coupling * before.coupling) / (2 * det);
  const double most = mean + std::sqrt(std::max(0.0, mean * mean - det_now / det));
  change.most = std::max(change.most, most);
  change.least = std::min(change.least, det_now / det / most);
  return true;
}

}  // namespace

std::optional<StiffnessChange> stiffness_change(const std::vector<SectionStiffness>& before,
                                                const std::vector<Link>& now) {
  StiffnessChange change{HUGE_VAL, 0};
  if (before.size() != now.size()) return {};
  for (std::size_t k = 0; k < now.size(); ++k) {
    const SectionStiffness &old = before[k], &c = now[k].stiffness;
    const bool coupled = old.coupling != 0 || c.coupling != 0;
    if (!take(old.kn, c.kn, change) || !take(old.kt, c.kt, change)) return {};
    if (coupled ? !take_coupled(old, c, change) : !take(old.ks, c.ks, change) || !take(old.kb, c.kb, change))
      return {};
  }
  if (!(change.least > 0) || !std::isfinite(change.spread())) return {};
  return change;
}

int iterations_for(double spread, double reduction) {
  const double root = std::sqrt(std::max(1.0, spread));
  const double rate = (root - 1) / (root + 1);
  if (rate <= reduction / 2) return 1;
  return int(std::min(1e6, std::ceil(std::log(reduction / 2) / std::log(rate))));
}

KeptFactor::KeptFactor(std::unique_ptr<LinearSolver> direct, const AnalysisReport& analysis,
                       const DirectRates& rates, int threads)
    : direct_(std::move(direct)), analysis_(analysis), rates_(rates), threads_(threads) {}

AnalysisReport KeptFactor::analyse(const BondNetwork& network, const FreeDofs& dofs) {
  factorised_.clear();
  return analysis_ = direct_->analyse(network, dofs);
}

bool KeptFactor::worth_keeping(const StiffnessChange& change, const BondNetwork& network) const {
  const double begun_at = std::min(1.0, change.spread() - 1);
  const int more = 2 * iterations_for(change.spread(), std::min(1.0, enough / begun_at)) - solves_of_its_own;
  return more * kept_factor_seconds(analysis_, Index(network.links.size())) <=
         factorisation_seconds(analysis_, rates_);
}

FactorReport KeptFactor::factorise(const BondNetwork& network, const FreeDofs& dofs) {
  network_ = &network;
  dofs_ = &dofs;
  kept_.reset();
  // Near rounding a factor is no preconditioner, and what its pivots say holds for its own numbers alone.
  constexpr double sound_pivots = 0x1p-40;
  if (!factorised_.empty() && factor_.pivot_ratio > sound_pivots) {
    kept_ = stiffness_change(factorised_, network.links);
    if (kept_ && worth_keeping(*kept_, network)) return factor_;
    kept_.reset();
  }
  return factorise_anew(network, dofs);
}

FactorReport KeptFactor::factorise_anew(const BondNetwork& network, const FreeDofs& dofs) {
  factorised_.clear();
  factor_ = direct_->factorise(network, dofs);
  incidence_ = link_incidence(network);
  for (const Link& link : network.links) factorised_.push_back(link.stiffness);
  return factor_;
}

Eigen::MatrixXd KeptFactor::product(const Eigen::MatrixXd& motions) const {
  const double length = network_->rotation_length;
  Eigen::MatrixXd forces(motions.rows(), motions.cols());
  for (Index c = 0; c < motions.cols(); ++c) {
    BodyVectors<double> motion(std::size_t(network_->bodies), Vector6::Zero());
    for_each_unknown(*dofs_, [&](std::size_t p, int i, Index unknown) {
      motion[p][i] = motions(unknown, c) / (i < 3 ? 1 : length);
    });
    const auto q = link_resultants<double>(*network_, motion, threads_);
    forces.col(c) = to_unknowns(gather_forces<double>(*network_, incidence_, q, threads_), *dofs_, length);
  }
  return forces;
}

Eigen::MatrixXd KeptFactor::solve(const Eigen::MatrixXd& right_hand_sides) {
  iterations_ = 0;
  if (!kept_) return direct_->solve(right_hand_sides);
  if (kept_->spread() - 1 <= reduction) {
    // u . K u between least and most of u . K_0 u: the best multiple of the factor's answer is that close.
    iterations_ = 1;
    return 2 / (kept_->least + kept_->most) * direct_->solve(right_hand_sides);
  }
  const int most = 2 * iterations_for(kept_->spread(), reduction) + 2;
  Eigen::MatrixXd r = right_hand_sides;
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(r.rows(), r.cols()), p = x;
  const Eigen::VectorXd enough = reduction * r.colwise().norm().transpose();
  Eigen::VectorXd before = Eigen::VectorXd::Ones(r.cols());
  const auto reached = [&](Index c) { return r.col(c).norm() <= enough[c]; };
  const auto all_reached = [&] {
    for (Index c = 0; c < r.cols(); ++c)
      if (!reached(c)) return false;
    return true;
  };
  // Columns go together, because a factor is read once for all of them; each on its own steps.
  while (!all_reached()) {
    if (iterations_ == most) {
      // Rounding has the better of it: this is what the bound on iterations does not know.
      kept_.reset();
      factorise_anew(*network_, *dofs_);
      return direct_->solve(right_hand_sides);
    }
    const Eigen::MatrixXd z = direct_->solve(r);
    for (Index c = 0; c < r.cols(); ++c) {
      const double energy = r.col(c).dot(z.col(c));
      p.col(c) = z.col(c) + (iterations_ > 0 ? energy / before[c] : 0) * p.col(c);
      before[c] = energy;
    }
    const Eigen::MatrixXd carried = product(p);
    for (Index c = 0; c < r.cols(); ++c) {
      const double work = p.col(c).dot(carried.col(c));
      if (!(work > 0)) continue;
      x.col(c) += before[c] / work * p.col(c);
      r.col(c) -= before[c] / work * carried.col(c);
    }
    ++iterations_;
  }
  return x;
}

}  // namespace bondstatic
