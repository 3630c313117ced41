#include "fracture/low_rank_solver.hpp"

#include <gtest/gtest.h>

#include "bondstatic/bond_law.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

struct Packed {
  Model model;
  BondNetwork network;
  FreeDofs dofs;
};

/// The lowest particles are held, some of them in part.
Packed packed(const std::string& law, const Values& values) {
  std::mt19937_64 random(3);
  Packed made{random_packing(random, 5, block(law, values)), {}, {}};
  made.network = bond_network(made.model, bond_properties(made.model));
  std::vector<std::uint8_t> free(made.model.particles.size(), 0x3f);
  for (std::size_t p = 0; p < free.size(); ++p)
    if (made.model.particles[p].position.z() < 0.5) free[p] = p % 2 ? 0 : 0x28;
  made.dofs = number_free_dofs(free);
  return made;
}

Eigen::MatrixXd solved_anew(const BondNetwork& network, const FreeDofs& dofs, const Eigen::MatrixXd& b) {
  const auto solver = make_solver("auto", 1);
  solver->analyse(network, dofs);
  solver->factorise(network, dofs);
  return solver->solve(b);
}

double apart(const Eigen::MatrixXd& l, const Eigen::MatrixXd& r) {
  return (l - r).cwiseAbs().maxCoeff() / r.cwiseAbs().maxCoeff();
}

// Stepped sections couple shear and bending; contact bonds have no moments.
class LowRank : public ::testing::TestWithParam<std::pair<std::string, Values>> {};

TEST_P(LowRank, LinksTakenOutOneByOneAreAsInAFactorOfTheRest) {
  Packed p = packed(GetParam().first, GetParam().second);
  LowRankSolver solver(make_solver("auto", 1));
  solver.analyse(p.network, p.dofs);
  solver.factorise(p.network, p.dofs);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(p.dofs.unknowns(), 2);
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<Link> out;
    for (int i = 0; i <= round % 3; ++i) {
      Link& link = p.network.links[random() % p.network.links.size()];
      if (link.stiffness.kn == 0) continue;
      out.push_back(link);
      link.stiffness = {};
    }
    ASSERT_GT(solver.take_out(out, 1e-6), 1e-6);
    EXPECT_LT(apart(solver.solve(b), solved_anew(p.network, p.dofs, b)), 1e-12) << "round " << round;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, LowRank,
    ::testing::Values(std::pair<std::string, Values>{"timoshenko",
                                                     {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}},
                      std::pair<std::string, Values>{"two-segment", {{"young", 1e9}, {"poisson", 0.2}}},
                      std::pair<std::string, Values>{"contact", {{"kn", 1e7}, {"ks", 5e6}}}),
    [](const auto& chosen) {
      return chosen.param.first == "two-segment" ? "TwoSegment" : chosen.param.first;
    });

TEST(LowRank, SaysThatNothingHoldsABodyThatLosesItsLastLink) {
  Model model = chain(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(10, 0, 0), 10, 0.4);
  const BondNetwork network = bond_network(model, bond_properties(model));
  std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
  free[0] = 0;
  const FreeDofs dofs = number_free_dofs(free);
  LowRankSolver solver(make_solver("auto", 1));
  solver.analyse(network, dofs);
  solver.factorise(network, dofs);
  EXPECT_LT(solver.take_out({network.links[4]}, 1e-3), 1e-9);
  EXPECT_EQ(solver.rank(), 0);
}

TEST(LowRank, PinnedAndLeftOutABodyIsAsIfItWereNotThere) {
  Packed p = packed("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}});
  LowRankSolver solver(make_solver("auto", 1));
  solver.analyse(p.network, p.dofs);
  solver.factorise(p.network, p.dofs);
  const Index body = 62;
  std::vector<Link> around;
  for (Link& link : p.network.links)
    if (link.a == body || link.b == body) {
      around.push_back(link);
      link.stiffness = {};
    }
  solver.pin(body, 1e8);
  ASSERT_GT(solver.take_out(around, 1e-9), 1e-9);
  std::vector<std::uint8_t> free = p.dofs.free;
  free[std::size_t(body)] = 0;
  const FreeDofs rest = number_free_dofs(free);
  solver.keep_only(rest);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(rest.unknowns(), 3);
  EXPECT_LT(apart(solver.solve(b), solved_anew(p.network, rest, b)), 1e-12);
}

}  // namespace
}  // namespace bondstatic::test
