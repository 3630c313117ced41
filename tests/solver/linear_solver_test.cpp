// The contract of linear_solver.hpp, for every backend of this build.
#include "bondstatic/linear_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "bondstatic/error.hpp"
#include "support/models.hpp"
#include "system/assemble.hpp"

namespace bondstatic::test {
namespace {

struct Problem {
  BondNetwork network;
  FreeDofs dofs;

  explicit Problem(int edge, double young = 5e9) {
    std::mt19937_64 random(7);
    const Model model =
        random_packing(random, edge, block("timoshenko", {{"young", young}, {"poisson", 0.2}}));
    network = bond_network(model, bond_properties(model));
    std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
    free[0] = 0;
    free[1] = 0b101101;
    free.back() = 0b000111;
    dofs = number_free_dofs(std::move(free));
  }

  Eigen::MatrixXd matrix() const {
    const Incidence incidence = link_incidence(network);
    const BodyGraph graph = body_graph(network, incidence);
    SparseMatrix k = stiffness_pattern(graph, dofs);
    assemble(network, incidence, graph, dofs, 1, k);
    const Eigen::MatrixXd lower(k);
    return lower.selfadjointView<Eigen::Lower>();
  }
};

// What an iterative solver leaves over is brought to it again, as its contract says; a direct one is asked
// once.
Eigen::MatrixXd solved(LinearSolver& solver, const Eigen::MatrixXd& k, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd x = solver.solve(b);
  for (int again = 0; solver.iterative() && again < 3; ++again) x += solver.solve(b - k * x);
  return x;
}

class Backend : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<LinearSolver> solver = make_solver(GetParam(), 2);
};

TEST_P(Backend, SolvesAllColumnsAtOnce) {
  const Problem problem(4);
  const AnalysisReport report = solver->analyse(problem.network, problem.dofs);
  EXPECT_EQ(report.unknowns, problem.dofs.unknowns());
  if (!solver->iterative()) {
    EXPECT_GE(report.factor_entries, report.matrix_entries);
    EXPECT_GT(report.factor_flops, double(report.factor_entries));
  }
  EXPECT_GT(report.predicted_bytes, 8.0 * double(report.factor_entries));
  const FactorReport factor = solver->factorise(problem.network, problem.dofs);
  EXPECT_EQ(factor.broken_at, -1);
  EXPECT_GT(factor.pivot_ratio, 1e-6);
  EXPECT_LE(factor.pivot_ratio, 1);
  const Eigen::MatrixXd k = problem.matrix(), exact = Eigen::MatrixXd::Random(k.rows(), 3);
  const Eigen::MatrixXd found = solved(*solver, k, k * exact);
  EXPECT_LT((found - exact).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST_P(Backend, TakesChangedValuesOnOneAnalysis) {
  const Problem soft(3, 1e9), stiff(3, 4e9);
  solver->analyse(soft.network, soft.dofs);
  const Eigen::MatrixXd load = Eigen::MatrixXd::Random(soft.dofs.unknowns(), 1);
  solver->factorise(soft.network, soft.dofs);
  const Eigen::MatrixXd first = solved(*solver, soft.matrix(), load);
  solver->factorise(stiff.network, stiff.dofs);
  EXPECT_LT((4 * solved(*solver, stiff.matrix(), load) - first).lpNorm<Eigen::Infinity>(),
            1e-12 * first.lpNorm<Eigen::Infinity>());
}

TEST_P(Backend, AnalysesAnewWhereSupportsChange) {
  for (const int edge : {3, 2, 4}) {
    const Problem problem(edge);
    solver->analyse(problem.network, problem.dofs);
    solver->factorise(problem.network, problem.dofs);
    const Eigen::MatrixXd k = problem.matrix(), exact = Eigen::MatrixXd::Ones(k.rows(), 1);
    EXPECT_LT((solved(*solver, k, k * exact) - exact).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

// A sweep asks again and again for one pattern; the links may come in another order.
TEST_P(Backend, KnowsThePatternAgain) {
  Problem problem(3);
  const AnalysisReport first = solver->analyse(problem.network, problem.dofs);
  std::reverse(problem.network.links.begin(), problem.network.links.end());
  const AnalysisReport again = solver->analyse(problem.network, problem.dofs);
  EXPECT_EQ(again.factor_entries, first.factor_entries);
  EXPECT_EQ(again.factor_flops, first.factor_flops);
  EXPECT_EQ(again.ordering, first.ordering);
  solver->factorise(problem.network, problem.dofs);
  const Eigen::MatrixXd k = problem.matrix(), exact = Eigen::MatrixXd::Ones(k.rows(), 1);
  EXPECT_LT((solved(*solver, k, k * exact) - exact).lpNorm<Eigen::Infinity>(), 1e-10);
}

// One body fewer free or one bond fewer is another pattern, although the sizes of the graph may agree.
TEST_P(Backend, TellsPatternsOfOneSizeApart) {
  Problem problem(3);
  solver->analyse(problem.network, problem.dofs);
  std::vector<std::uint8_t> free = problem.dofs.free;
  std::swap(free[0], free[5]);
  problem.dofs = number_free_dofs(std::move(free));
  solver->analyse(problem.network, problem.dofs);
  solver->factorise(problem.network, problem.dofs);
  const Eigen::MatrixXd k = problem.matrix(), exact = Eigen::MatrixXd::Ones(k.rows(), 1);
  EXPECT_LT((solved(*solver, k, k * exact) - exact).lpNorm<Eigen::Infinity>(), 1e-10);
}

// Ordered by minimum degree the factor takes less than half the operations of the order in which particles
// came.
TEST(EigenSolver, OrdersTheParticles) {
  const Problem problem(12);
  const double unknowns = double(problem.dofs.unknowns());
  const double band = 6.0 * 12 * 12;  // of the natural order
  EXPECT_LT(make_solver("eigen", 1)->analyse(problem.network, problem.dofs).factor_flops,
            0.5 * unknowns * band * band);
}

TEST_P(Backend, SaysWhereTheFactorisationBreaks) {
  Problem problem(2);
  for (Link& link : problem.network.links)
    if (link.a == 5 || link.b == 5) link.stiffness = {-1, -1, -1, -1, 0};  // not a stiffness: K is indefinite
  solver->analyse(problem.network, problem.dofs);
  const FactorReport factor = solver->factorise(problem.network, problem.dofs);
  if (solver->iterative() && factor.pivot_ratio > 0) {  // it may notice only when it solves
    const Eigen::VectorXd load = Eigen::VectorXd::Random(problem.dofs.unknowns());
    solver->solve(load);
    EXPECT_FALSE(solver->last_solve().reached);
    return;
  }
  EXPECT_EQ(factor.pivot_ratio, 0);
  EXPECT_GE(factor.broken_at, -1);
  EXPECT_LT(factor.broken_at, problem.dofs.unknowns());
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const SolverInfo& info : available_solvers()) list.push_back(info.name);
  return list;
}

TEST(LinearSolver, MultigridSaysWhereItsRowsEnd) {
  BondNetwork network;
  network.bodies = Index(1) << 32;
  try {
    make_solver("multigrid", 1)->analyse(network, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_NE(std::string(error.what()).find("4294967296"), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(LinearSolver, Backend, ::testing::ValuesIn(names()), [](const auto& chosen) {
  std::string name = chosen.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(LinearSolver, UnknownNameIsAnsweredWithThoseOfThisBuild) {
  try {
    make_solver("pardiso", 1);
    FAIL() << "made a solver that does not exist";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    for (const std::string& name : names())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
  }
}

}  // namespace
}  // namespace bondstatic::test
