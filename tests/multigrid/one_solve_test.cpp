// What one solve by the cycle and conjugate gradients leaves, before rounds of refinement go on from there.
#include <gtest/gtest.h>

#include "bondstatic/linear_solver.hpp"
#include "model/boundary.hpp"
#include "multigrid/hard_models.hpp"
#include "system/assemble.hpp"

namespace bondstatic::test {
namespace {

/// In the norm of the energy, error over answer, of one solve for random motions.
double left_over(const Model& model, unsigned seed) {
  const BondNetwork network = bond_network(model, bond_properties(model));
  const FreeDofs dofs = number_free_dofs(boundary_of(model, 0).free);
  const Incidence incidence = link_incidence(network);
  const BodyGraph graph = body_graph(network, incidence);
  SparseMatrix lower = stiffness_pattern(graph, dofs);
  assemble(network, incidence, graph, dofs, 1, lower);
  const auto k = lower.selfadjointView<Eigen::Lower>();

  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd exact(dofs.unknowns());
  for (double& x : exact) x = normal(random);
  const auto solver = make_solver("multigrid", 1);
  solver->analyse(network, dofs);
  solver->factorise(network, dofs);
  const Eigen::VectorXd force = k * exact, error = solver->solve(force) - exact;
  EXPECT_TRUE(solver->last_solve().reached);
  return std::sqrt(error.dot(k * error) / exact.dot(force));
}

// 1e-6 is asked for, in the norm of the cycle; the last step is taken on the word of the one before it.
TEST(OneSolve, ReachesItsGoal) {
  std::mt19937_64 random(6);
  for (const HardModel& kind : {HardModel{.count = {12, 12, 12}}, HardModel{.decades = 3},
                                HardModel{.hinges = 0.3}, HardModel{.size_ratio = 6}}) {
    const Model model = hard_model(random, kind);
    for (unsigned seed = 0; seed < 5; ++seed) EXPECT_LT(left_over(model, seed), 3e-6);
  }
}

}  // namespace
}  // namespace bondstatic::test
