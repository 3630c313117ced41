#include "bench/after_break.hpp"

#include <cholmod.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bench/timing.hpp"
#include "bondstatic/bond.hpp"
#include "fracture/low_rank_solver.hpp"
#include "solver/expand_ordering.hpp"
#include "solver/machine.hpp"
#include "system/assemble.hpp"

namespace bondstatic::bench {

namespace {

struct Entry {
  Index unknown;
  double value;
};

/// Columns w with B^T C B = sum w w^T in the unknowns, six of them at most.
std::vector<std::vector<Entry>> columns_of(const Link& link, const FreeDofs& dofs, double length) {
  // Scaled first: what an eigenvalue is wrong by is rounding of the largest one.
  Vector12 scale = Vector12::Ones();
  scale.segment<3>(3).setConstant(1 / length);
  scale.tail<3>().setConstant(1 / length);
  const Eigen::SelfAdjointEigenSolver<Matrix12> modes(scale.asDiagonal() * stiffness_matrix(link) *
                                                      scale.asDiagonal());
  std::vector<std::vector<Entry>> columns;
  for (int m = 0; m < 12; ++m) {
    if (!(modes.eigenvalues()[m] > 1e-12 * modes.eigenvalues()[11])) continue;
    const Vector12 w = std::sqrt(modes.eigenvalues()[m]) * modes.eigenvectors().col(m);
    auto& column = columns.emplace_back();
    for (const auto& [body, first] : {std::pair{link.a, 0}, std::pair{link.b, 6}}) {
      Index unknown = dofs.first[std::size_t(body)];
      for (int i = 0; i < 6; ++i)
        if (dofs.is_free(body, i)) column.push_back({unknown++, w[first + i]});
    }
  }
  return columns;
}

class Downdates final : public AfterBreak {
 public:
  Downdates(const BondNetwork& network, const FreeDofs& dofs)
      : dofs_(dofs), length_(network.rotation_length) {
    cholmod_l_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
    const Incidence incidence = link_incidence(network);
    const BodyGraph graph = body_graph(network, incidence);
    SparseMatrix k = stiffness_pattern(graph, dofs);
    assemble(network, incidence, graph, dofs, 1, k);
    const SolverThreads guard(1);
    std::vector<Index> order = expand_ordering(ordered(graph), dofs);
    cholmod_sparse a = view(k, -1);
    factor_ = cholmod_l_analyze_p(&a, order.data(), nullptr, 0, &common_);
    cholmod_l_factorize(&a, factor_, &common_);
    ready_seconds = seconds_of([&] { cholmod_l_change_factor(CHOLMOD_REAL, 0, 0, 0, 1, factor_, &common_); });
    if (common_.status != CHOLMOD_OK) throw std::runtime_error("CHOLMOD made no simplicial factor");
    // Values, row indices.
    factor_bytes = 16.0 * double(factor_->nzmax);
    place_.resize(factor_->n);
    const Index* permutation = static_cast<const Index*>(factor_->Perm);
    for (std::size_t i = 0; i < place_.size(); ++i) place_[std::size_t(permutation[i])] = Index(i);
  }

  ~Downdates() override {
    cholmod_l_free_factor(&factor_, &common_);
    cholmod_l_finish(&common_);
  }

  void take_out(const Link& link) override {
    const SolverThreads guard(1);
    const auto columns = columns_of(link, dofs_, length_);
    SparseMatrix w(Index(factor_->n), Index(columns.size()));
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (const auto& [unknown, value] : columns[j])
        entries.emplace_back(place_[std::size_t(unknown)], Index(j), value);
    if (entries.empty()) return;  // both ends are held
    w.setFromTriplets(entries.begin(), entries.end());
    cholmod_sparse c = view(w, 0);
    if (!cholmod_l_updown(0, &c, factor_, &common_)) throw std::runtime_error("CHOLMOD's downdate failed");
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) override {
    const SolverThreads guard(1);
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = std::size_t(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, factor_, &right, &common_);
    Eigen::VectorXd answer = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(x->x), b.size());
    cholmod_l_free_dense(&x, &common_);
    return answer;
  }

 private:
  static cholmod_sparse view(SparseMatrix& m, int stype) {
    cholmod_sparse a{};
    a.nrow = std::size_t(m.rows());
    a.ncol = std::size_t(m.cols());
    a.nzmax = std::size_t(m.nonZeros());
    a.p = m.outerIndexPtr();
    a.i = m.innerIndexPtr();
    a.x = m.valuePtr();
    a.stype = stype;
    a.itype = CHOLMOD_LONG;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = a.packed = 1;
    return a;
  }

  // As the solver does from 2,000 bodies on.
  std::vector<Index> ordered(const BodyGraph& graph) {
    const std::size_t bodies = graph.offset.size() - 1;
    std::vector<Index> order(bodies);
    cholmod_sparse g{};
    g.nrow = g.ncol = bodies;
    g.nzmax = graph.neighbour.size();
    g.p = const_cast<Index*>(graph.offset.data());
    g.i = const_cast<Index*>(graph.neighbour.data());
    g.stype = 1;
    g.itype = CHOLMOD_LONG;
    g.xtype = CHOLMOD_PATTERN;
    g.sorted = g.packed = 1;
    if (!cholmod_l_metis(&g, nullptr, 0, 0, order.data(), &common_))
      cholmod_l_amd(&g, nullptr, 0, order.data(), &common_);
    return order;
  }

  const FreeDofs& dofs_;
  double length_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  std::vector<Index> place_;  // of each unknown in the factor
};

class LowRank final : public AfterBreak {
 public:
  LowRank(const BondNetwork& network, const FreeDofs& dofs) : solver_(make_solver("cholmod", 1)) {
    factor_bytes = 8.0 * double(solver_.analyse(network, dofs).factor_entries);
    solver_.factorise(network, dofs);
  }
  void take_out(const Link& link) override {
    if (!(solver_.take_out({link}, 1e-9) >= 1e-9)) throw std::runtime_error("something came loose");
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) override { return solver_.solve(b); }

 private:
  LowRankSolver solver_;
};

class Iteration final : public AfterBreak {
 public:
  Iteration(const BondNetwork& network, const FreeDofs& dofs)
      : dofs_(dofs), length_(network.rotation_length), solver_(make_solver("cholmod", 1)) {
    const Incidence incidence = link_incidence(network);
    const BodyGraph graph = body_graph(network, incidence);
    k_ = stiffness_pattern(graph, dofs);
    assemble(network, incidence, graph, dofs, 1, k_);
    factor_bytes = 8.0 * double(solver_->analyse(network, dofs).factor_entries);
    solver_->factorise(network, dofs);
  }

  void take_out(const Link& link) override {
    for (const auto& column : columns_of(link, dofs_, length_))
      for (const auto& [row, value] : column)
        for (const auto& [other, with] : column)
          if (row >= other) k_.coeffRef(row, other) -= value * with;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) override {
    constexpr double enough = 1e-14;
    constexpr int most = 1000;
    const auto k = k_.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), r = b, z = preconditioned(r), p = z, kp;
    double rz = r.dot(z);
    for (iterations_ = 0; iterations_ < most && r.norm() > enough * b.norm();) {
      ++iterations_;
      kp = k * p;
      const double step = rz / p.dot(kp);
      x += step * p;
      r -= step * kp;
      z = preconditioned(r);
      const double before = std::exchange(rz, r.dot(z));
      p = z + rz / before * p;
    }
    return x;
  }

  int iterations() const override { return iterations_; }

 private:
  Eigen::VectorXd preconditioned(const Eigen::VectorXd& r) { return solver_->backward(solver_->forward(r)); }

  const FreeDofs& dofs_;
  double length_;
  std::unique_ptr<LinearSolver> solver_;
  SparseMatrix k_;
  int iterations_ = 0;
};

}  // namespace

std::unique_ptr<AfterBreak> by_downdates(const BondNetwork& network, const FreeDofs& dofs) {
  return std::make_unique<Downdates>(network, dofs);
}

std::unique_ptr<AfterBreak> by_low_rank(const BondNetwork& network, const FreeDofs& dofs) {
  return std::make_unique<LowRank>(network, dofs);
}

std::unique_ptr<AfterBreak> by_iteration(const BondNetwork& network, const FreeDofs& dofs) {
  return std::make_unique<Iteration>(network, dofs);
}

}  // namespace bondstatic::bench
