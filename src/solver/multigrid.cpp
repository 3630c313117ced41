// The clump multigrid as a backend: src/multigrid in float first, in double where float does not do.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "bondstatic/error.hpp"
#include "multigrid/flexible_cg.hpp"
#include "solver/backends.hpp"
#include "solver/cost_model.hpp"
#include "system/together.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

using namespace multigrid;

class Multigrid final : public LinearSolver {
 public:
  explicit Multigrid(int threads) : threads_(threads) {}

  AnalysisReport analyse(const BondNetwork& network, const FreeDofs& dofs) override {
    if (network.bodies >= std::numeric_limits<std::uint32_t>::max())
      throw Error(ExitCode::invalid_input,
                  fmt::format("multigrid numbers at most 2^32 - 1 particles, found {}\n"
                              "    cure: --solver petsc on several machines",
                              network.bodies));
    incidence_ = link_incidence(network);
    plan_ = {};
    AnalysisReport report;
    report.ordering = "clumps";
    report.unknowns = dofs.first[std::size_t(network.own())];
    for (const Link& link : network.links) report.matrix_entries += network.owns(link) ? 36 : 0;
    report.predicted_bytes =
        linear_cost(network.bodies, Index(network.links.size()), multigrid_rates, threads_).bytes;
    if (Ranks* const ranks = ranks_of(network)) {
      report.unknowns = Index(sum_of_all(ranks, double(report.unknowns)));
      report.matrix_entries = Index(sum_of_all(ranks, double(report.matrix_entries)));
      report.predicted_bytes = largest_of_all(ranks, report.predicted_bytes) * ranks->on_this_machine();
    }
    return report;
  }

  FactorReport factorise(const BondNetwork& network, const FreeDofs& dofs) override {
    network_ = &network;
    dofs_ = dofs;
    double_.reset();
    single_ = build_hierarchy<float>(network, incidence_, dofs, threads_, plan_);
    if (single_->coarsest.positive()) return {};
    to_double();
    return double_->coarsest.positive() ? FactorReport{} : FactorReport{0, -1};
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) override {
    Eigen::MatrixXd answer(right_hand_sides.rows(), right_hand_sides.cols());
    report_ = {};
    for (Index column = 0; column < right_hand_sides.cols(); ++column) {
      iterations_ = 0;
      solve_one(right_hand_sides.col(column), answer.col(column));
      report_.iterations = std::max(report_.iterations, iterations_);
    }
    return answer;
  }

  bool iterative() const override { return true; }
  SolveReport last_solve() const override { return report_; }

 private:
  void to_double() {
    single_.reset();
    double_ = build_hierarchy<double>(*network_, incidence_, dofs_, threads_, plan_);
  }

  using Given = Eigen::Ref<const Eigen::VectorXd>;
  using Answer = Eigen::Ref<Eigen::VectorXd>;

  void solve_one(const Given& b, Answer answer) {
    Rows<double> x, r = to_rows(b);
    if (single_) {
      const Convergence in_float = flexible_cg(*single_, {1e-6, 150, 20}, threads_, r, x);
      if (in_float.reached) return take(x, in_float, *single_, answer);
      report_.note = fmt::format("went over to double precision after {} iterations", in_float.iterations);
      iterations_ += in_float.iterations;
      to_double();
      r = to_rows(b);
    }
    const Convergence in_double = flexible_cg(*double_, {1e-10, 2000, 200}, threads_, r, x);
    take(x, in_double, *double_, answer);
  }

  Rows<double> to_rows(const Given& b) const {
    const auto& body = plan_.numbering.front().body;
    const Index count = Index(body.size());
    Rows<double> rows = make_rows<double>(count, 0, threads_);
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1 && count > worth_threads)
    for (Index row = 0; row < count; ++row) {
      const Index p = body[std::size_t(row)];
      Index unknown = dofs_.first[std::size_t(p)];
      for (int i = 0; i < 6; ++i)
        if (dofs_.is_free(p, i)) rows[std::size_t(row)].at[i] = b[unknown++];
    }
    return rows;
  }

  template <class Scalar>
  void take(Rows<double>& x, const Convergence& convergence, const Hierarchy<Scalar>& of, Answer answer) {
    refresh(of.levels.front().halo, x);
    iterations_ += convergence.iterations;
    report_.reduction = std::max(report_.reduction, convergence.reduction);
    report_.reached = report_.reached && convergence.reached;
    const auto& row = plan_.numbering.front().row;
    for_each_unknown(dofs_, threads_, [&](std::size_t p, int i, Index unknown) {
      answer[unknown] = x[std::size_t(row[p])].at[i] / of.units.stiffness;
    });
  }

  int threads_;
  Incidence incidence_;
  Plan plan_;
  const BondNetwork* network_ = nullptr;
  FreeDofs dofs_;
  std::optional<Hierarchy<float>> single_;
  std::optional<Hierarchy<double>> double_;
  SolveReport report_;
  int iterations_ = 0;  ///< of the column being solved
};

}  // namespace

std::unique_ptr<LinearSolver> make_multigrid(int threads) {
  return std::make_unique<Multigrid>(threads);
}

}  // namespace bondstatic
