// One model solved by several ranks: the answer of one process.
#include "statics/partners.hpp"

#include <gtest/gtest.h>

#include "bondstatic/mechanism.hpp"
#include "io/message.hpp"
#include "support/models.hpp"
#include "support/periodic.hpp"
#include "support/shuffled.hpp"
#include "support/thread_ranks.hpp"
#include "system/bisection.hpp"

namespace bondstatic::test {
namespace {

std::vector<int> bisected(const Model& model, int ranks) {
  std::vector<Vector3> positions;
  for (const Particle& particle : model.particles) positions.push_back(particle.position);
  return bisect(positions, ranks);
}

// State of the whole, put together from what each rank says of its own.
struct Together {
  std::vector<StaticSolution> by_rank;
  std::vector<Vector6> displacement, reaction;  // of the first load case
  std::vector<BondResult> bonds;
};

Together solve_on(int ranks, const Model& model, const std::vector<int>& rank_of,
                  const StaticOptions& options) {
  Together all;
  all.by_rank.resize(std::size_t(ranks));
  all.displacement.resize(model.particles.size());
  all.reaction.resize(model.particles.size());
  all.bonds.resize(model.bonds.size());
  const Cut cut(model, rank_of, ranks);
  run_ranks(ranks, [&](Ranks& mine) {
    const Piece piece = unpacked<Piece>(packed(cut.piece(mine.rank())));
    StaticSolution solution = solve_statics(Partners{piece, mine, [&] { return model; }}, options);
    const State& state = solution.cases.front();
    for (std::size_t p = 0; p < std::size_t(piece.own); ++p) {
      all.displacement[std::size_t(piece.particle[p])] = state.displacement[p];
      all.reaction[std::size_t(piece.particle[p])] = state.reaction[p];
    }
    for (std::size_t k = 0; k < piece.bond.size(); ++k)
      if (piece.owns(piece.model.bonds[k])) all.bonds[std::size_t(piece.bond[k])] = state.bonds[k];
    all.by_rank[std::size_t(mine.rank())] = std::move(solution);
  });
  return all;
}

StaticOptions options() {
  StaticOptions options;
  options.solver = "multigrid";
  options.threads = 1;
  return options;
}

double largest(const std::vector<Vector6>& vectors) {
  double size = 0;
  for (const Vector6& v : vectors)
    for (const double x : v)
      if (!std::isnan(x)) size = std::max(size, std::abs(x));
  return size;
}

double apart(const std::vector<Vector6>& a, const std::vector<Vector6>& b) {
  double most = 0;
  for (std::size_t p = 0; p < a.size(); ++p)
    for (int i = 0; i < 6; ++i) {
      if (std::isnan(a[p][i]) != std::isnan(b[p][i])) return not_given;
      if (!std::isnan(a[p][i])) most = std::max(most, std::abs(a[p][i] - b[p][i]));
    }
  return most / largest(b);
}

Model packing(int edge, std::mt19937_64& random) {
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}}));
  for (Index p = 0; p < Index(model.particles.size()); ++p) {
    const Vector3& x = model.particles[std::size_t(p)].position;
    if (x.z() < 0.5) fix_all(model, p);
    if (x.z() > edge - 1.5) load(model, p, vector6(1, 2, -3, 0.1, 0, 0.2));
  }
  return model;
}

void expect_the_same(const Together& found, const StaticSolution& expected) {
  const LoadCaseResult& one = expected.cases.front();
  EXPECT_LT(apart(found.displacement, one.displacement), 3e-16);
  EXPECT_LT(apart(found.reaction, one.reaction), 1e-13);
  double normal = 0, worst = 0;
  for (const BondResult& bond : one.bonds) normal = std::max(normal, std::abs(bond.normal_force));
  for (std::size_t k = 0; k < one.bonds.size(); ++k)
    worst = std::max(worst, std::abs(found.bonds[k].normal_force - one.bonds[k].normal_force));
  EXPECT_LT(worst, 1e-12 * normal);
  for (const StaticSolution& solution : found.by_rank) {
    const LoadCaseResult& part = solution.cases.front();
    EXPECT_NEAR(part.energy / one.energy, 1, 1e-14);
    EXPECT_NEAR(part.work / one.work, 1, 1e-14);
    EXPECT_LT(part.accuracy.backward_error, 1e-14);
    EXPECT_LT(part.accuracy.forward_error, 1e-13);
    EXPECT_LT(part.accuracy.force_balance, 1e-12);
    EXPECT_LT(part.accuracy.energy_balance, 1e-12);
    EXPECT_EQ(part.accuracy.refinements, found.by_rank.front().cases.front().accuracy.refinements);
    EXPECT_EQ(solution.report.analysis.unknowns, expected.report.analysis.unknowns);
  }
}

TEST(Partners, FindTheAnswerOfOneProcess) {
  std::mt19937_64 random(5);
  for (const int edge : {5, 9, 14}) {
    const Model model = packing(edge, random);
    const StaticSolution expected = solve_statics(model, options());
    for (const int ranks : {1, 2, 3, 4}) {
      SCOPED_TRACE(testing::Message() << edge << " on " << ranks);
      const Together found = solve_on(ranks, model, bisected(model, ranks), options());
      expect_the_same(found, expected);
      EXPECT_LT(found.by_rank.front().report.iterations, 1.5 * double(expected.report.iterations) + 5);
    }
  }
}

// Pieces of so many particles are solved in an order of their own, where not all ranks have so many.
TEST(Partners, FindTheAnswerOfALargeModelInAnyOrder) {
  std::mt19937_64 random(17);
  const Model model = shuffled(packing(30, random), random);
  const StaticSolution expected = solve_statics(model, options());
  std::vector<int> uneven;
  for (const Particle& particle : model.particles) uneven.push_back(particle.position.x() > 20);
  for (const auto& rank_of : {uneven, std::vector<int>(model.particles.size(), 1)})
    expect_the_same(solve_on(2, model, rank_of, options()), expected);
}

TEST(Partners, NameFaultyBondsOfALargeModelInTheOrderOfTheTable) {
  std::mt19937_64 random(19);
  Model model = packing(30, random);
  for (Bond& bond : model.bonds)
    if (random() % 1000 == 0) bond.branch = Vector3::Zero();
  model = shuffled(model, random);
  const auto told = [](auto solve) -> std::string {
    try {
      solve();
    } catch (const InputError& error) {
      return error.what();
    }
    return "solved";
  };
  const Cut cut(model, std::vector<int>(model.particles.size(), 0), 1);
  const std::string expected = told([&] { bond_properties(model); });
  EXPECT_NE(expected, "solved");
  std::string found;
  run_ranks(1, [&](Ranks& mine) {
    const Piece piece = cut.piece(0);
    found = told([&] { solve_statics(Partners{piece, mine, [&] { return model; }}, options()); });
  });
  EXPECT_EQ(found, expected);
}

TEST(Partners, FindItHoweverTheModelIsCut) {
  std::mt19937_64 random(7);
  const Model model = packing(7, random);
  const StaticSolution expected = solve_statics(model, options());
  std::vector<int> scattered, alone(model.particles.size(), 2), slices;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    scattered.push_back(int(random() % 3));
    slices.push_back(int(model.particles[p].position.x()) % 3);
  }
  for (const auto& rank_of : {scattered, alone, slices})
    expect_the_same(solve_on(3, model, rank_of, options()), expected);
}

TEST(Partners, FindTheStiffnessOfAPeriodicCell) {
  std::mt19937_64 random(11);
  const Model model =
      periodic_packing(random, 6, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}, {"radius", 0.2}}));
  const StaticSolution expected = solve_statics(model, options());
  const double size = expected.effective->stiffness.norm();
  for (const int ranks : {1, 2, 3}) {
    SCOPED_TRACE(ranks);
    const Together found = solve_on(ranks, model, bisected(model, ranks), options());
    EXPECT_LT(apart(found.displacement, expected.cases.front().displacement), 1e-15);
    for (const StaticSolution& solution : found.by_rank) {
      EXPECT_LT((solution.effective->stiffness - expected.effective->stiffness).norm(), 1e-14 * size);
      EXPECT_LT((solution.effective->voigt - expected.effective->voigt).norm(), 1e-14 * size);
      EXPECT_LT(solution.cases.front().accuracy.energy_balance, 1e-13);
      EXPECT_LT(solution.cases.front().accuracy.moment_balance, 1e-13);
    }
  }
}

// Rollers, prescribed motion, bonds without moments among others, several bodies, load cases with different
// supports, rattlers: of each something lies at a cut.
Model mixed(std::mt19937_64& random) {
  Model model = random_packing(random, 6, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}}));
  model.blocks.push_back(block("generic", {{"kn", 1e9}, {"ks", 3e8}, {"kt", 0}, {"kb", 0}}));
  Index hinges = 0;
  for (Bond& bond : model.bonds)
    if (random() % 10 == 0) bond.block = 1, bond.in_block = hinges++;
  model.load_cases = {"push", "shear", "lift"};
  for (Index p = 0; p < Index(model.particles.size()); ++p) {
    const Vector3& x = model.particles[std::size_t(p)].position;
    if (x.z() < 0.5)
      model.supports.push_back(
          {p, {true, true, true, p % 2 == 0, false, false}, Vector6::Zero(), every_case});
    if (x.z() > 4.5 && x.x() < 1) load(model, p, vector6(1, 2, -3), p / 6 % 3);
    if (x.z() > 4.5 && x.x() > 4)
      model.supports.push_back({p, {false, false, true, false, false, false}, vector6(0, 0, 1e-3), 1});
  }
  for (int i = 0; i < 3; ++i) add_particle(model, Vector3(2 * i, 2.5, 20), 0.5);  // rattlers, one alone
  const Index first = Index(model.particles.size()) - 3;
  add_bond(model, first, first + 1);
  model.bonds.back().in_block = Index(model.bonds.size()) - 1 - hinges;
  load(model, first + 2, vector6(0, 0, 7));
  return model;
}

TEST(Partners, FindItForAllThatAModelMayHave) {
  std::mt19937_64 random(11);
  const Model model = mixed(random);
  StaticOptions given = options();
  given.unsupported = Unsupported::drop;
  const StaticSolution expected = solve_statics(model, given);
  ASSERT_EQ(expected.report.factorisations, 2);
  for (const int ranks : {2, 3, 4}) {
    const Together found = solve_on(ranks, model, bisected(model, ranks), given);
    expect_the_same(found, expected);
    const StaticReport& report = found.by_rank.front().report;
    EXPECT_EQ(report.factorisations, 2);
    EXPECT_EQ(report.dropped, expected.report.dropped);
    EXPECT_EQ(report.warnings, expected.report.warnings);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(found.by_rank[0].cases[c].name, expected.cases[c].name);
      EXPECT_NEAR(found.by_rank[0].cases[c].energy / expected.cases[c].energy, 1, 1e-14);
    }
  }
}

TEST(Partners, NameAMechanismAsOneProcessDoes) {
  std::mt19937_64 random(13);
  Model floating = packing(5, random), rolling = floating;
  floating.supports.clear();
  for (Support& support : rolling.supports) support.fixed = {false, false, true, false, false, false};
  for (const Model& model : {floating, rolling}) {
    std::string expected;
    try {
      solve_statics(model, options());
      FAIL();
    } catch (const MechanismError& error) {
      expected = error.what();
    }
    std::vector<std::string> said(3);
    const Cut cut(model, bisected(model, 3), 3);
    run_ranks(3, [&](Ranks& mine) {
      const Piece piece = cut.piece(mine.rank());
      try {
        solve_statics(Partners{piece, mine, [&] { return model; }}, options());
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mechanism);
        said[std::size_t(mine.rank())] = error.what();
      }
    });
    EXPECT_EQ(said[0], expected);
    EXPECT_FALSE(said[1].empty());
    EXPECT_FALSE(said[2].empty());
  }
}

}  // namespace
}  // namespace bondstatic::test
