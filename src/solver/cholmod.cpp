// CHOLMOD, supernodal, 64-bit. What its measured traps demand is done here: see SolverThreads and analyse().
#include <cholmod.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "solver/backends.hpp"
#include "solver/cholmod_factor.hpp"
#include "solver/cholmod_halves.hpp"
#include "solver/cost_model.hpp"
#include "solver/expand_ordering.hpp"
#include "solver/machine.hpp"
#include "system/assemble.hpp"

namespace bondstatic {

namespace {

// A supernode and its parent become one while that leaves at most this share of zeros: any up to the first
// width, 90, 20 and 2 % up to the next ones and beyond. Six columns a body make even leaves wide, and wide
// supernodes are what BLAS lives on. CHOLMOD's own (4, 16, 48; 80, 10, 5 %) pays 8 % more operations for
// zeros in the widest supernodes, where nothing is to be gained, and makes the small ones too small: on
// 27,000 particles 66 to 69 % of dgemm's rate against 71 to 79 % with these.
constexpr std::size_t merge_width[3] = {12, 48, 96};
constexpr double merge_zeros[3] = {0.9, 0.2, 0.02};

// BLAS divides every supernode among its threads. Those of a small factor are done before the others have
// woken up.
constexpr double flops_worth_threads = 3e9;

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
    std::copy_n(merge_width, 3, common_.nrelax);
    std::copy_n(merge_zeros, 3, common_.zrelax);
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
    BodyGraph graph = body_graph(network, incidence_);
    if (factor_ && graph == graph_ && dofs.free == free_) return report_;
    cholmod_l_free_factor(&factor_, &common_);  // it belongs to another pattern from here on
    graph_ = std::move(graph);
    free_ = dofs.free;
    matrix_ = stiffness_pattern(graph_, dofs);
    report_ = {};
    std::vector<Index> order = expand_ordering(order_bodies(report_.ordering), dofs);
    cholmod_sparse a = view();
    factor_ = cholmod_l_analyze_p(&a, order.data(), nullptr, 0, &common_);
    check("analysis");
    report_.unknowns = matrix_.cols();
    report_.matrix_entries = matrix_.nonZeros();
    report_.factor_entries = Index(factor_->xsize);
    report_.factor_flops = common_.fl;
    report_.predicted_bytes = predict_bytes(network);
    return report_;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    assemble(network, incidence_, graph_, dofs, threads_, matrix_);
    const SolverThreads guard(blas_threads());
    cholmod_sparse a = view();
    cholmod_l_factorize(&a, factor_, &common_);
    if (common_.status == CHOLMOD_NOT_POSDEF)
      return {0, static_cast<const Index*>(factor_->Perm)[std::min(factor_->minor, factor_->n - 1)]};
    check("factorisation");
    return {pivot_ratio(*factor_, matrix_), -1};
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    const SolverThreads guard(blas_threads());
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

  bool has_halves() const override { return true; }

  Eigen::MatrixXd forward(const Eigen::MatrixXd& b) override {
    const Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 1>> order(
        static_cast<const Index*>(factor_->Perm), b.rows());
    Eigen::MatrixXd x = b(order, Eigen::all);
    solve_lower(*factor_, x);
    return x;
  }

  Eigen::MatrixXd backward(Eigen::MatrixXd y) override {
    solve_upper(*factor_, y);
    const Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 1>> order(
        static_cast<const Index*>(factor_->Perm), y.rows());
    Eigen::MatrixXd x(y.rows(), y.cols());
    x(order, Eigen::all) = y;
    return x;
  }

 private:
  int blas_threads() const { return report_.factor_flops < flops_worth_threads ? 1 : threads_; }

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

  // What is held here, CHOLMOD's permuted copy of K, and what statics keeps for each link and body while it
  // refines and recovers one load case.
  double predict_bytes(const BondNetwork& network) const {
    const double links = double(network.links.size()), bodies = double(network.bodies);
    const double copy = 16.0 * double(matrix_.nonZeros()) + 8.0 * double(matrix_.cols());
    return factor_bytes(*factor_) + 2 * copy + 32.0 * links + 16.0 * bodies + solution_bytes(links, bodies);
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
  std::vector<std::uint8_t> free_;  // of the last analysis, as the graph: what the pattern hangs on
  SparseMatrix matrix_;
  AnalysisReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod(int threads) {
  return std::make_unique<Cholmod>(threads);
}

}  // namespace bondstatic
