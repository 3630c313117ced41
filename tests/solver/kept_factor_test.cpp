// A factor that answers for other numbers: what its bounds tell, and that it does.
#include "solver/kept_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "model/boundary.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

Link link_of(const SectionStiffness& c) {
  Link link;
  link.stiffness = c;
  return link;
}

TEST(KeptFactor, ChangeIsBoundedByTheRatiosOfAllNumbers) {
  const auto change = stiffness_change({{1, 2, 3, 4, 0}, {5, 0, 0, 0, 0}},
                                       {link_of({2, 3, 9, 4, 0}), link_of({20, 0, 0, 0, 0})});
  ASSERT_TRUE(change);
  EXPECT_EQ(change->least, 1);
  EXPECT_EQ(change->most, 4);
}

TEST(KeptFactor, ChangeOfCoupledShearAndBendingIsThatOfTheirPencil) {
  const SectionStiffness before{1, 2, 1, 3, 0.7}, now{1, 5, 1, 2, -1.1};
  Eigen::Matrix2d old, c;
  old << before.ks, before.coupling, before.coupling, before.kb;
  c << now.ks, now.coupling, now.coupling, now.kb;
  const Eigen::Vector2d ratios =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(c, old).eigenvalues();
  const auto change = stiffness_change({before}, {link_of(now)});
  ASSERT_TRUE(change);
  EXPECT_NEAR(change->least, ratios[0], 1e-14);
  EXPECT_NEAR(change->most, ratios[1], 1e-14);
}

TEST(KeptFactor, StiffnessThatComesOrGoesHasNoBounds) {
  EXPECT_FALSE(stiffness_change({{1, 1, 0, 1, 0}}, {link_of({1, 1, 1, 1, 0})}));
  EXPECT_FALSE(stiffness_change({{1, 1, 1, 1, 0}}, {link_of({1, 1, 1, 0, 0})}));
  EXPECT_FALSE(stiffness_change({{1, 1, 1, 1, 0}}, {link_of({1, 1, 1, 1, 1})}));
}

TEST(KeptFactor, IterationsFollowTheBoundOfConjugateGradients) {
  EXPECT_EQ(iterations_for(1, 1e-12), 1);
  EXPECT_EQ(iterations_for(1 + 1e-9, 1e-9), 1);
  EXPECT_EQ(iterations_for(4, 1e-6), int(std::ceil(std::log(2e6) / std::log(3.0))));
}

/// A packing with its free bodies, of which each bond's numbers may be changed.
struct Packing {
  Model model;
  BondNetwork network;
  FreeDofs dofs;
  AnalysisReport analysis;
  std::unique_ptr<KeptFactor> solver;

  explicit Packing(int edge) {
    std::mt19937_64 random(4);
    model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
    for (Index p = 0; p < edge * edge; ++p) fix_all(model, p);
    network = bond_network(model, bond_properties(model, 1));
    dofs = number_free_dofs(boundary_of(model, 0).free);
    auto direct = make_solver("auto", 1);
    analysis = direct->analyse(network, dofs);
    solver = std::make_unique<KeptFactor>(std::move(direct), analysis, cholmod_rates, 1);
    solver->factorise(network, dofs);
  }

  /// Each number of each bond by a factor of its own from 1 to 1 + most.
  void change(double most) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> by(1, 1 + most);
    for (Link& link : network.links) {
      link.stiffness.kn *= by(random);
      link.stiffness.ks *= by(random);
      link.stiffness.kt *= by(random);
      link.stiffness.kb *= by(random);
    }
  }

  /// Largest difference to a factorisation of its own, relative.
  double error() const {
    const Eigen::MatrixXd forces = Eigen::MatrixXd::Random(dofs.unknowns(), 2);
    auto fresh = make_solver("auto", 1);
    fresh->analyse(network, dofs);
    fresh->factorise(network, dofs);
    const Eigen::MatrixXd expected = fresh->solve(forces);
    return (solver->solve(forces) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  }
};

// One multiple of the factor's answer, whose bound is 5e-7 in the energy's norm.
TEST(KeptFactor, NumbersVeryCloseTakeOneIteration) {
  Packing packing(6);
  packing.change(1e-6);
  packing.solver->factorise(packing.network, packing.dofs);
  ASSERT_TRUE(packing.solver->kept());
  EXPECT_LE(packing.error(), 1e-6);
  EXPECT_EQ(packing.solver->last_solve().iterations, 1);
}

// What is left of the residual is at most 2^-18, so that it is little more of the answer.
TEST(KeptFactor, NumbersCloseByTakeConjugateGradients) {
  Packing packing(6);
  packing.change(2e-5);
  packing.solver->factorise(packing.network, packing.dofs);
  ASSERT_TRUE(packing.solver->kept());
  EXPECT_LE(packing.error(), 4e-6);
  EXPECT_GE(packing.solver->last_solve().iterations, 1);
  EXPECT_LE(packing.solver->last_solve().iterations,
            iterations_for(packing.solver->kept()->spread(), 0x1p-18) + 1);
}

TEST(KeptFactor, AModulusOfAllBondsTakesOneIteration) {
  Packing packing(6);
  for (Link& link : packing.network.links)
    for (double SectionStiffness::*number :
         {&SectionStiffness::kn, &SectionStiffness::ks, &SectionStiffness::kt, &SectionStiffness::kb})
      link.stiffness.*number *= 1.7;
  packing.solver->factorise(packing.network, packing.dofs);
  ASSERT_TRUE(packing.solver->kept());
  EXPECT_LE(packing.error(), 1e-9);
  EXPECT_EQ(packing.solver->last_solve().iterations, 1);
}

TEST(KeptFactor, FactorisesAnewWhereThatIsLess) {
  Packing packing(6);
  packing.change(1);
  packing.solver->factorise(packing.network, packing.dofs);
  EXPECT_FALSE(packing.solver->kept());
  EXPECT_LE(packing.error(), 1e-9);
  EXPECT_EQ(packing.solver->last_solve().iterations, 0);
}

}  // namespace
}  // namespace bondstatic::test
