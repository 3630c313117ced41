// Each rank solves its share of a network, cut here by hand; held against the whole, solved without ranks.
// Run by any number of ranks: all run all tests, in the same order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "bondstatic/error.hpp"
#include "bondstatic/linear_solver.hpp"
#include "solver/petsc_module.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr int edge = 6;
constexpr Index columns = 2;

struct Whole {
  Model model;
  BondNetwork network;
  FreeDofs dofs;

  Whole() {
    std::mt19937_64 random(3);
    model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
    // Far from the origin, as in the coordinates of a survey.
    for (Particle& particle : model.particles) particle.position += Vector3(1e6, -2e6, 3e6);
    network = bond_network(model, bond_properties(model));
    for (const std::size_t k : {10u, 200u}) {  // a second link between two bodies, the other way round
      const Link link = network.links[k];
      network.links.push_back({link.b, link.a, -link.branch, 1 - link.fraction, link.stiffness});
    }
    std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
    for (std::size_t p = 0; p < edge * edge; ++p) free[p] = p % 3 ? 0b111000 : 0b010101;
    free[0] = free[7] = free[100] = 0;
    dofs = number_free_dofs(std::move(free));
  }

  Eigen::MatrixXd loads() const {
    Eigen::MatrixXd b(dofs.unknowns(), columns);
    for (Index i = 0; i < b.size(); ++i) b.data()[i] = std::sin(1.7 * double(i)) + 0.1;
    return b;
  }
};

using RankOf = std::function<int(Index body, const Vector3& position)>;

struct Share {
  std::vector<Index> body;  ///< of each local one, in the whole
  NetworkShare share;
  BondNetwork network;
  FreeDofs dofs;

  Share(const Whole& whole, const RankOf& rank_of, Ranks& ranks) {
    const int rank = ranks.rank();
    share.ranks = &ranks;
    std::vector<int> owner;
    for (Index p = 0; p < whole.network.bodies; ++p)
      owner.push_back(rank_of(p, whole.model.particles[std::size_t(p)].position));
    std::set<Index> copies;
    std::map<int, std::set<Index>> lent, borrowed;
    for (Index p = 0; p < whole.network.bodies; ++p)
      if (owner[std::size_t(p)] == rank) body.push_back(p);
    share.own = Index(body.size());
    for (const Link& link : whole.network.links)
      for (const auto& [here, there] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
        const int other = owner[std::size_t(there)];
        if (owner[std::size_t(here)] != rank || other == rank) continue;
        copies.insert(there);
        lent[other].insert(here);
        borrowed[other].insert(there);
      }
    body.insert(body.end(), copies.begin(), copies.end());
    std::map<Index, Index> local;
    for (const Index p : body) local.emplace(p, Index(local.size()));
    std::vector<std::uint8_t> free;
    for (const Index p : body) {
      share.position.push_back(whole.model.particles[std::size_t(p)].position);
      free.push_back(whole.dofs.free[std::size_t(p)]);
    }
    dofs = number_free_dofs(std::move(free));
    for (const auto& [other, bodies] : lent) {
      Neighbour& neighbour = share.neighbours.emplace_back();
      neighbour.rank = other;
      for (const Index p : bodies) neighbour.lent.push_back(local.at(p));
      for (const Index p : borrowed[other]) neighbour.borrowed.push_back(local.at(p));
    }
    network.bodies = Index(body.size());
    network.rotation_length = whole.network.rotation_length;
    for (Link link : whole.network.links) {
      if (owner[std::size_t(link.a)] != rank && owner[std::size_t(link.b)] != rank) continue;
      link.a = local.at(link.a);
      link.b = local.at(link.b);
      network.links.push_back(link);
    }
    network.share = &share;
  }
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;

  BondNetwork stiffer(double factor) const {
    BondNetwork scaled = network;
    for (Link& link : scaled.links)
      for (double SectionStiffness::*k : {&SectionStiffness::kn, &SectionStiffness::ks, &SectionStiffness::kt,
                                          &SectionStiffness::kb, &SectionStiffness::coupling})
        link.stiffness.*k *= factor;
    return scaled;
  }

  /// Values of all unknowns, of which these bodies have some.
  Eigen::MatrixXd of(const Whole& whole, const Eigen::MatrixXd& values) const {
    Eigen::MatrixXd mine(dofs.unknowns(), values.cols());
    for (std::size_t p = 0; p < body.size(); ++p)
      mine.middleRows(dofs.first[p], dofs.first[p + 1] - dofs.first[p]) =
          values.middleRows(whole.dofs.first[std::size_t(body[p])], dofs.first[p + 1] - dofs.first[p]);
    return mine;
  }
};

double largest(const Eigen::MatrixXd& values) {
  return values.size() ? values.lpNorm<Eigen::Infinity>() : 0;
}

struct Cut {
  const char* name;
  RankOf rank_of;
};

std::vector<Cut> cuts(int ranks) {
  return {{"in oblique slabs",
           [=](Index, const Vector3& x) {
             const double across = (x[0] - 1e6 + 0.4 * (x[1] + 2e6) + 0.2 * (x[2] - 3e6)) / (1.6 * edge);
             return std::clamp(int(across * ranks), 0, ranks - 1);
           }},
          {"one by one", [=](Index p, const Vector3&) { return int(p * 7 % ranks); }},
          {"one body alone, the others at the last rank",
           [=](Index p, const Vector3&) { return p == 50 ? 0 : ranks - 1; }},
          {"what is held apart", [=](Index p, const Vector3&) { return p == 0 || p == 7 ? 0 : ranks - 1; }}};
}

struct Method {
  const char* name;
  std::vector<std::string> options;
  double apart;  ///< at most, of the largest value
};

// Measured: 3e-14, 4e-14.
const Method methods[] = {{"petsc-mumps", {}, 1e-12}, {"petsc", {"-ksp_rtol", "1e-13"}, 1e-12}};

TEST(PetscShare, OwnBodiesAndCopiesGetTheAnswerOfTheWhole) {
  const auto ranks = petsc_module().join_ranks();
  const Whole whole;
  const Eigen::MatrixXd b = whole.loads();
  const auto reference = make_solver("eigen", 1);
  const AnalysisReport expected = reference->analyse(whole.network, whole.dofs);
  reference->factorise(whole.network, whole.dofs);
  const Eigen::MatrixXd x = reference->solve(b);
  for (const Cut& cut : cuts(ranks->size())) {
    const Share share(whole, cut.rank_of, *ranks);
    Eigen::MatrixXd mine = share.of(whole, b);
    // Nobody may look at the loads of copies.
    const Index own = share.dofs.first[std::size_t(share.share.own)];
    mine.bottomRows(mine.rows() - own).setConstant(std::numeric_limits<double>::quiet_NaN());
    for (const Method& method : methods) {
      SCOPED_TRACE(std::string(method.name) + ", " + cut.name);
      const auto solver = make_solver(method.name, 1, method.options);
      const AnalysisReport report = solver->analyse(share.network, share.dofs);
      EXPECT_EQ(report.unknowns, expected.unknowns);
      EXPECT_EQ(report.matrix_entries, expected.matrix_entries);
      EXPECT_EQ(ranks->broadcast(std::to_string(report.predicted_bytes)),
                std::to_string(report.predicted_bytes));
      for (const double stiffness : {1.0, 4.0}) {  // new values on the same pattern
        const BondNetwork network = share.stiffer(stiffness);
        EXPECT_EQ(solver->factorise(network, share.dofs).pivot_ratio, 1);
        const Eigen::MatrixXd answer = solver->solve(mine), expected_here = share.of(whole, x / stiffness);
        ASSERT_TRUE(answer.allFinite());
        EXPECT_LT(largest(answer - expected_here), method.apart * largest(x) / stiffness);
      }
    }
  }
}

// With modes of positions that are not where the bodies are they would be many.
TEST(PetscShare, RigidModesKeepTheIterationsFew) {
  const auto ranks = petsc_module().join_ranks();
  const Whole whole;
  const Share share(whole, cuts(ranks->size())[0].rank_of, *ranks);
  const auto solver = make_solver("petsc", 1);
  solver->analyse(share.network, share.dofs);
  solver->factorise(share.network, share.dofs);
  solver->solve(share.of(whole, whole.loads()));
  EXPECT_TRUE(solver->last_solve().reached);
  EXPECT_LE(solver->last_solve().iterations, 18);
}

TEST(PetscShare, SeveralRanksRefuseAWholeNetwork) {
  const auto ranks = petsc_module().join_ranks();
  const Whole whole;
  for (const char* name : {"petsc", "petsc-mumps"}) {
    const auto solver = make_solver(name, 1);
    if (ranks->size() == 1) {
      EXPECT_EQ(solver->analyse(whole.network, whole.dofs).unknowns, whole.dofs.unknowns());
      continue;
    }
    try {
      solver->analyse(whole.network, whole.dofs);
      FAIL() << "took it";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), testing::HasSubstr("share"));
    }
  }
}

}  // namespace
}  // namespace bondstatic::test
