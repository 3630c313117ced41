#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/error.hpp"
#include "bondstatic/linear_solver.hpp"
#include "support/models.hpp"
#include "system/assemble.hpp"

namespace bondstatic::test {
namespace {

struct Problem {
  BondNetwork network;
  FreeDofs dofs;
  Eigen::SparseMatrix<double> k;

  explicit Problem(int edge) {
    std::mt19937_64 random(3);
    const Model model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
    network = bond_network(model, bond_properties(model));
    std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
    for (std::size_t p = 0; p < std::size_t(edge * edge); ++p) free[p] = p % 3 ? 0b111000 : 0b010101;
    free[0] = 0;
    dofs = number_free_dofs(std::move(free));
    const Incidence incidence = link_incidence(network);
    const BodyGraph graph = body_graph(network, incidence);
    SparseMatrix lower = stiffness_pattern(graph, dofs);
    assemble(network, incidence, graph, dofs, 1, lower);
    k = SparseMatrix(lower.selfadjointView<Eigen::Lower>());
  }

  double reduction(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    return (b - k * x).norm() / b.norm();
  }
};

TEST(Petsc, TellsTheTrueReductionOfTheResidual) {
  const Problem problem(7);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(problem.k.rows());
  for (const char* tolerance : {"1e-2", "1e-5", "1e-8"}) {
    const auto solver = make_solver("petsc", 1, {"-ksp_rtol", tolerance});
    solver->analyse(problem.network, problem.dofs);
    solver->factorise(problem.network, problem.dofs);
    const Eigen::VectorXd x = solver->solve(b);
    const SolveReport report = solver->last_solve();
    EXPECT_TRUE(report.reached);
    EXPECT_LE(report.reduction, std::stod(tolerance));
    // The two matrices differ by their rounding only.
    EXPECT_NEAR(report.reduction, problem.reduction(b, x), 1e-11);
    EXPECT_GT(report.iterations, 0);
  }
}

// Without the modes, or with half of them zero, smoothed aggregation takes several times as many.
TEST(Petsc, RigidModesKeepTheIterationsFewAtAnySize) {
  for (const int edge : {6, 14}) {
    const Problem problem(edge);
    const auto solver = make_solver("petsc", 1);
    solver->analyse(problem.network, problem.dofs);
    solver->factorise(problem.network, problem.dofs);
    solver->solve(Eigen::VectorXd::Ones(problem.k.rows()));
    EXPECT_LE(solver->last_solve().iterations, 25) << edge;
  }
}

TEST(Petsc, SaysWhereItGaveUp) {
  const Problem problem(5);
  const auto solver = make_solver("petsc", 1, {"-ksp_max_it", "2"});
  solver->analyse(problem.network, problem.dofs);
  solver->factorise(problem.network, problem.dofs);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(problem.k.rows()), x = solver->solve(b);
  EXPECT_FALSE(solver->last_solve().reached);
  EXPECT_THAT(solver->last_solve().note, testing::HasSubstr("DIVERGED_ITS"));
  EXPECT_LT(problem.reduction(b, x), 1);  // a step forward all the same
}

TEST(Petsc, ZeroLoadIsAnsweredByZero) {
  const Problem problem(3);
  const auto solver = make_solver("petsc", 1);
  solver->analyse(problem.network, problem.dofs);
  solver->factorise(problem.network, problem.dofs);
  EXPECT_TRUE(solver->solve(Eigen::MatrixXd::Zero(problem.k.rows(), 2)).isZero(0));
  EXPECT_TRUE(solver->last_solve().reached);
}

TEST(Petsc, OptionsOfASolverDoNotLastIntoTheNext) {
  const Problem problem(4);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(problem.k.rows());
  const auto iterations = [&](const std::vector<std::string>& options) {
    const auto solver = make_solver("petsc", 1, options);
    solver->analyse(problem.network, problem.dofs);
    solver->factorise(problem.network, problem.dofs);
    solver->solve(b);
    return solver->last_solve().iterations;
  };
  const int usual = iterations({});
  EXPECT_GT(iterations({"-pc_type", "jacobi"}), 2 * usual);
  EXPECT_EQ(iterations({}), usual);
}

TEST(PetscMumps, PredictsItsFactor) {
  const Problem problem(10);
  const auto solver = make_solver("petsc-mumps", 1);
  const AnalysisReport report = solver->analyse(problem.network, problem.dofs);
  EXPECT_GT(report.factor_entries, 2 * report.matrix_entries);
  EXPECT_GT(report.factor_flops, 10.0 * double(report.factor_entries));
  EXPECT_GT(report.predicted_bytes, 8.0 * double(report.factor_entries));
  EXPECT_LT(report.predicted_bytes, 80.0 * double(report.factor_entries));
}

}  // namespace
}  // namespace bondstatic::test
