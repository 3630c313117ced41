// CHOLMOD, supernodal, 64-bit. What its measured traps demand is done here: see SolverThreads and analyse().
#include <cholmod.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "solver/backends.hpp"
#include "solver/expand_ordering.hpp"
#include "solver/machine.hpp"
#include "system/assemble.hpp"

namespace bondstatic {

namespace {

// Above this many bodies METIS halves the flops of AMD; below, AMD is as good and starts at once.
constexpr Index metis_from = 2000;

class Cholmod final : public LinearSolver {
 public:
  explicit Cholmod(int threads) : threads_(threads) {
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.quick_return_if_not_posdef = 1;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
  }

  ~Cholmod() override {
    cholmod_l_free_factor(&factor_, &common_);
    cholmod_l_finish(&common_);
  }

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override {
    const SolverThreads guard(threads_);
    incidence_ = link_incidence(network);
    graph_ = body_graph(network, incidence_);
    matrix_ = stiffness_pattern(graph_, dofs);
    AnalysisReport report;
    std::vector<Index> order = expand_ordering(order_bodies(report.ordering), dofs);
    cholmod_l_free_factor(&factor_, &common_);
    cholmod_sparse a = view();
    factor_ = cholmod_l_analyze_p(&a, order.data(), nullptr, 0, &common_);
    check("analysis");
    report.unknowns = matrix_.cols();
    report.matrix_entries = matrix_.nonZeros();
    report.factor_entries = Index(factor_->xsize);
    report.factor_flops = common_.fl;
    report.predicted_bytes = predict_bytes(network);
    return report;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    assemble(network, incidence_, graph_, dofs, threads_, matrix_);
    const SolverThreads guard(threads_);
    cholmod_sparse a = view();
    cholmod_l_factorize(&a, factor_, &common_);
    if (common_.status == CHOLMOD_NOT_POSDEF)
      return {0, static_cast<const Index*>(factor_->Perm)[std::min(factor_->minor, factor_->n - 1)]};
    check("factorisation");
    return {pivot_ratio(), -1};
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    const SolverThreads guard(threads_);
    cholmod_dense b{};
    b.nrow = b.d = std::size_t(right_hand_sides.rows());
    b.ncol = std::size_t(right_hand_sides.cols());
    b.nzmax = b.nrow * b.ncol;
    b.x = const_cast<double*>(right_hand_sides.data());
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, factor_, &b, &common_);
    check("solution");
    Eigen::MatrixXd answer = Eigen::Map<Eigen::MatrixXd>(static_cast<double*>(x->x), right_hand_sides.rows(),
                                                         right_hand_sides.cols());
    cholmod_l_free_dense(&x, &common_);
    return answer;
  }

 private:
  // K seen by CHOLMOD without a copy.
  cholmod_sparse view() {
    cholmod_sparse a{};
    a.nrow = a.ncol = std::size_t(matrix_.cols());
    a.nzmax = std::size_t(matrix_.nonZeros());
    a.p = matrix_.outerIndexPtr();
    a.i = matrix_.innerIndexPtr();
    a.x = matrix_.valuePtr();
    a.stype = -1;
    a.itype = CHOLMOD_LONG;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = a.packed = 1;
    return a;
  }

  std::vector<Index> order_bodies(std::string& name) {
    const Index bodies = Index(graph_.offset.size()) - 1;
    std::vector<Index> order(static_cast<std::size_t>(bodies));
    cholmod_sparse g{};
    g.nrow = g.ncol = std::size_t(bodies);
    g.nzmax = graph_.neighbour.size();
    g.p = graph_.offset.data();
    g.i = graph_.neighbour.data();
    g.stype = 1;
    g.itype = CHOLMOD_LONG;
    g.xtype = CHOLMOD_PATTERN;
    g.sorted = g.packed = 1;
    if (bodies >= metis_from && cholmod_l_metis(&g, nullptr, 0, 0, order.data(), &common_)) {
      name = "METIS on particles";
      return order;
    }
    cholmod_l_amd(&g, nullptr, 0, order.data(), &common_);
    check("ordering");
    name = "AMD on particles";
    return order;
  }

  // Supernodal factor, its index lists and workspace, CHOLMOD's permuted copy of K, K's own values, and what
  // refinement keeps for each link (resultants) and body (motion, residual, correction) in extended
  // precision.
  double predict_bytes(const BondNetwork& network) const {
    const double entries = double(matrix_.nonZeros());
    const double factor = 8.0 * double(factor_->xsize) + 8.0 * double(factor_->ssize + 3 * factor_->nsuper);
    const double copy = 16.0 * entries + 8.0 * double(matrix_.cols());
    const double refinement = 96.0 * double(network.links.size()) + 4 * 96.0 * double(network.bodies);
    return factor + 8.0 * double(factor_->maxcsize) + copy + 16.0 * entries + refinement;
  }

  double pivot_ratio() const {
    const auto* super = static_cast<const Index*>(factor_->super);
    const auto* rows_at = static_cast<const Index*>(factor_->pi);
    const auto* values_at = static_cast<const Index*>(factor_->px);
    const auto* values = static_cast<const double*>(factor_->x);
    const auto* permutation = static_cast<const Index*>(factor_->Perm);
    double smallest = 1;
    for (std::size_t s = 0; s < factor_->nsuper; ++s) {
      const Index rows = rows_at[s + 1] - rows_at[s];
      for (Index j = 0; j < super[s + 1] - super[s]; ++j) {
        const double pivot = values[values_at[s] + j * (rows + 1)];
        const Index column = permutation[super[s] + j];
        // The diagonal entry is the first of its column in the lower triangle.
        smallest = std::min(smallest, pivot * pivot / matrix_.valuePtr()[matrix_.outerIndexPtr()[column]]);
      }
    }
    return smallest;
  }

  void check(const char* phase) const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE)
      throw MemoryError(std::string("CHOLMOD ran out of memory in the ") + phase);
    if (common_.status < 0) throw Error(ExitCode::internal, std::string("CHOLMOD failed in the ") + phase);
  }

  int threads_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  Incidence incidence_;
  BodyGraph graph_;
  SparseMatrix matrix_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod(int threads) {
  return std::make_unique<Cholmod>(threads);
}

}  // namespace bondstatic
