// Eigen's SimplicialLDLT: no BLAS, no SuiteSparse, one thread.
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <numeric>

#include "bondstatic/error.hpp"
#include "solver/backends.hpp"
#include "solver/cost_model.hpp"
#include "solver/expand_ordering.hpp"
#include "system/assemble.hpp"

namespace bondstatic {

namespace {

class Factorisation
    : public Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<Index>> {
 public:
  // Eigen has the column counts after the analysis but shows them only after the factorisation.
  Index entries() const { return m_nonZerosPerCol.sum() + m_nonZerosPerCol.size(); }
  double flops() const {
    return m_nonZerosPerCol.cast<double>()
        .unaryExpr([](double count) { return (count + 1) * (count + 1); })
        .sum();
  }
};

class EigenSolver final : public LinearSolver {
 public:
  explicit EigenSolver(int threads) : threads_(threads) {}

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override {
    incidence_ = link_incidence(network);
    graph_ = body_graph(network, incidence_);
    matrix_ = stiffness_pattern(graph_, dofs);
    const std::vector<Index> order = expand_ordering(order_bodies(), dofs);
    permutation_.resize(Index(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i) permutation_.indices()[order[i]] = Index(i);
    permute();
    factor_.analyzePattern(permuted_);
    AnalysisReport report;
    report.ordering = "AMD on particles";
    report.unknowns = matrix_.cols();
    report.matrix_entries = matrix_.nonZeros();
    report.factor_entries = factor_.entries();
    report.factor_flops = factor_.flops();
    // The factor, K three times (as assembled, permuted, and the copy that the factorisation takes) and the
    // lists of the bodies.
    const double links = double(network.links.size()), bodies = double(network.bodies);
    report.predicted_bytes = 16.0 * double(report.factor_entries) + 48.0 * double(report.matrix_entries) +
                             32.0 * links + 16.0 * bodies + solution_bytes(links, bodies);
    return report;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    assemble(network, incidence_, graph_, dofs, threads_, matrix_);
    permute();
    factor_.factorize(permuted_);
    if (factor_.info() != Eigen::Success) return {0, 0};
    FactorReport report;
    const Eigen::VectorXd pivots = factor_.vectorD(), diagonal = permuted_.diagonal();
    for (Index i = 0; i < pivots.size(); ++i) {
      if (!(pivots[i] > 0)) {
        Index unknown = 0;
        while (permutation_.indices()[unknown] != i) ++unknown;
        return {0, unknown};
      }
      report.pivot_ratio = std::min(report.pivot_ratio, pivots[i] / diagonal[i]);
    }
    return report;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    const Eigen::MatrixXd permuted = permutation_ * right_hand_sides;
    return permutation_.transpose() * factor_.solve(permuted).eval();
  }

  bool has_halves() const override { return true; }

  Eigen::MatrixXd forward(const Eigen::MatrixXd& b) override {
    Eigen::MatrixXd x = permutation_ * b;
    factor_.matrixL().solveInPlace(x);
    return factor_.vectorD().cwiseSqrt().cwiseInverse().asDiagonal() * x;
  }

  Eigen::MatrixXd backward(Eigen::MatrixXd y) override {
    y = factor_.vectorD().cwiseSqrt().cwiseInverse().asDiagonal() * y;
    factor_.matrixU().solveInPlace(y);
    return permutation_.transpose() * y;
  }

 private:
  std::vector<Index> order_bodies() const {
    const Index bodies = Index(graph_.offset.size()) - 1;
    std::vector<Index> order(static_cast<std::size_t>(bodies));
    if (graph_.neighbour.empty()) {
      std::iota(order.begin(), order.end(), Index(0));
      return order;
    }
    // With the diagonal: Eigen's AMD puts a column without one last, as it does dense ones.
    SparseMatrix pattern(bodies, bodies);
    pattern.resizeNonZeros(Index(graph_.neighbour.size()) + bodies);
    Index at = 0;
    for (Index p = 0; p < bodies; ++p) {
      pattern.outerIndexPtr()[p] = at;
      const Index* next = graph_.neighbour.data() + graph_.offset[std::size_t(p)];
      const Index* end = graph_.neighbour.data() + graph_.offset[std::size_t(p) + 1];
      while (next != end && *next < p) pattern.innerIndexPtr()[at++] = *next++;
      pattern.innerIndexPtr()[at++] = p;
      while (next != end) pattern.innerIndexPtr()[at++] = *next++;
    }
    pattern.outerIndexPtr()[bodies] = at;
    std::fill_n(pattern.valuePtr(), pattern.nonZeros(), 1.0);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> elimination;
    Eigen::AMDOrdering<Index>()(pattern, elimination);
    std::copy_n(elimination.indices().data(), bodies, order.data());
    return order;
  }

  void permute() {
    permuted_.resize(matrix_.rows(), matrix_.cols());
    permuted_.selfadjointView<Eigen::Lower>() =
        matrix_.selfadjointView<Eigen::Lower>().twistedBy(permutation_);
  }

  int threads_;
  Incidence incidence_;
  BodyGraph graph_;
  SparseMatrix matrix_, permuted_;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> permutation_;
  Factorisation factor_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_eigen(int threads) {
  return std::make_unique<EigenSolver>(threads);
}

}  // namespace bondstatic
