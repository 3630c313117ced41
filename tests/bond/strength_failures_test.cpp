// The failure modes of a model's bonds: its blocks' criteria, bonds' own strengths, draws, faults.
#include <algorithm>

#include "bond/strength_fixture.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double inf = std::numeric_limits<double>::infinity();

BondStrength strength(const std::string& criterion, std::vector<double> parameters) {
  return {.criterion = criterion, .parameters = std::move(parameters)};
}

BondBlock block(const std::string& law, std::vector<double> parameters,
                std::optional<BondStrength> strength) {
  BondBlock out;
  out.law = law;
  out.parameters = std::move(parameters);
  out.strength = std::move(strength);
  return out;
}

/// A row of particles of radius 0.5, ids from 10, and Timoshenko bonds of radius 0.3 between neighbours.
Model row(Index bonds, std::optional<BondStrength> strength) {
  Model model;
  model.blocks.push_back(block("timoshenko", {1e9, 0.2, 0.3, not_given}, std::move(strength)));
  for (Index k = 0; k <= bonds; ++k) model.particles.push_back({10 + k, Vector3(double(k), 0, 0), 0.5});
  for (Index k = 0; k < bonds; ++k) model.bonds.push_back({k + 1, k, k + 1, Vector3::UnitX(), 0, k});
  return model;
}

BondFailures failures_of(const Model& model) {
  return bond_failures(model, bond_properties(model));
}

std::string said_of(const Model& model) {
  try {
    failures_of(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(BondFailures, AreTheModesOfEachBondsCriterion) {
  Model model = row(3, strength("musen", {5, 3}));
  model.blocks.push_back(block("contact", {1, 1, not_given}, strength("contact-bond", {2, 7})));
  model.blocks.push_back(block("generic", {1, 1, 1, 1, not_given}, {}));
  model.bonds[1].block = 1;
  model.bonds[2].block = 2;
  model.bonds[1].in_block = model.bonds[2].in_block = 0;
  const BondFailures failures = failures_of(model);
  EXPECT_THAT(failures.first, ElementsAre(0, 2, 4, 4));
  EXPECT_THAT(failures.strengths, ElementsAre(ElementsAre(5, 3), ElementsAre(2, 7), ElementsAre()));
  const auto expected =
      failure_modes("musen", {{"normal_strength", 5}, {"tangential_strength", 3}}, {0.3, 1, 0.5});
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_EQ(failures.of(0)[m].normal, expected[m].normal);
    EXPECT_EQ(failures.of(0)[m].bending, expected[m].bending);
    EXPECT_EQ(failures.of(0)[m].twisting, expected[m].twisting);
  }
  EXPECT_EQ(failures.of(1)[0].normal, 0.5);
  EXPECT_EQ(failures.of(1)[1].shear, 1.0 / 7);
  EXPECT_TRUE(failures.of(2).empty());
}

TEST(BondFailures, TakeStrengthsOfSingleBonds) {
  Model model = row(3, strength("brown", {not_given, 5, not_given}));
  model.blocks[0].strength->overrides = {{0, {not_given, 50, not_given}}, {2, {1, 2, 3}}};
  const BondFailures failures = failures_of(model);
  EXPECT_THAT(failures.strengths, ElementsAre(ElementsAre(inf, 5, 1, 4.0 / 3), ElementsAre(50, 5, 2, 4.0 / 3),
                                              ElementsAre(inf, 5, 3, 4.0 / 3)));
}

TEST(BondFailures, DoNotChangeWithTheOrderOfAnything) {
  for (const bool together : {false, true}) {
    BondStrength scattered = strength("edem-v2", {5, 3});
    scattered.scatter = BondStrength::Scatter::weibull;
    scattered.spread = {6, 4};
    scattered.seed = 7;
    scattered.together = together;
    const Model model = row(50, scattered);
    // Particles in reverse, bonds turned round and in reverse.
    Model other = model;
    const Index last = Index(model.particles.size()) - 1;
    std::reverse(other.particles.begin(), other.particles.end());
    std::reverse(other.bonds.begin(), other.bonds.end());
    for (std::size_t k = 0; k < other.bonds.size(); ++k) {
      Bond& bond = other.bonds[k];
      std::swap(bond.a, bond.b);
      bond.a = last - bond.a, bond.b = last - bond.b;
      bond.branch = -bond.branch;
      bond.in_block = Index(k);
    }
    const BondFailures here = failures_of(model), there = failures_of(other);
    for (std::size_t k = 0; k < model.bonds.size(); ++k) {
      const std::vector<double>& drawn = here.strengths[k];
      EXPECT_EQ(drawn, there.strengths[model.bonds.size() - 1 - k]);
      EXPECT_NE(drawn, here.strengths[(k + 1) % model.bonds.size()]);
      // One draw for all: the same quantile, whatever scale and modulus.
      const double quantiles[] = {std::pow(drawn[0] / 5, 6), std::pow(drawn[1] / 3, 4)};
      if (together)
        EXPECT_NEAR(quantiles[0] / quantiles[1], 1, 1e-13);
      else
        EXPECT_GT(std::abs(quantiles[0] / quantiles[1] - 1), 1e-6);
    }
  }
}

TEST(BondFailures, DrawApartForBondsBetweenTheSameParticles) {
  BondStrength scattered = strength("musen", {5, 3});
  scattered.scatter = BondStrength::Scatter::normal;
  scattered.spread = {0.2, 0};
  Model model = row(1, scattered);
  model.bonds.push_back({2, 1, 0, -Vector3::UnitX(), 0, 1});
  const BondFailures failures = failures_of(model);
  EXPECT_NE(failures.strengths[0][0], failures.strengths[1][0]);
  EXPECT_EQ(failures.strengths[0][1], 3);
  EXPECT_EQ(failures.strengths[1][1], 3);
}

TEST(BondFailures, NameBlocksWithFaults) {
  EXPECT_THAT(
      said_of(row(1, strength("edem", {5, 3}))),
      AllOf(HasSubstr("bonds.0 (strength edem): unknown criterion"), HasSubstr("edem-v2, pfc-parallel")));
  EXPECT_THAT(said_of(row(1, strength("edem-v2", {-5, not_given}))),
              AllOf(HasSubstr("bonds.0 (strength edem-v2): critical_normal_stress = -5: must be positive"),
                    HasSubstr("critical_shear_stress missing")));
  EXPECT_THAT(said_of(row(1, strength("edem-v2", {5, 3, 1}))),
              HasSubstr("3 strengths given, but edem-v2 takes 2"));
  BondStrength scattered = strength("pfc-parallel", {5, 3, 0.5, 1});
  scattered.scatter = BondStrength::Scatter::normal;
  scattered.spread = {-0.1, 0.1, 0.2, 0};
  EXPECT_THAT(said_of(row(1, scattered)),
              AllOf(HasSubstr("spread of tensile_strength = -0.1: must be finite, not negative"),
                    HasSubstr("spread = 0.2: not of a strength")));
}

TEST(BondFailures, NameBondsAndParticlesWithFaults) {
  Model model = row(2, strength("musen", {5, not_given}));
  model.blocks[0].strength->overrides = {{1, {3, -1}}};
  EXPECT_THAT(said_of(model), AllOf(HasSubstr("bond 2 between particles 11 and 12"),
                                    HasSubstr("tangential_strength = -1: must be positive"),
                                    testing::Not(HasSubstr("bond 1 "))));
  model = row(1, strength("edem-v2", {5, 3}));
  model.blocks[0].law = "contact";
  model.blocks[0].parameters = {1, 1, not_given};
  EXPECT_THAT(said_of(model), HasSubstr("edem-v2 speaks of stresses, but the bond has no section"));
  model.blocks[0].parameters = {1, 1, 0.3};
  EXPECT_EQ(said_of(model), "no fault");
  model.blocks[0].parameters = {1, 1, 1e-160};
  EXPECT_THAT(said_of(model),
              HasSubstr("utilisation in tension is not finite with the bond's radius 1e-160"));
  BondStrength wild = strength("contact-bond", {5, 3});
  wild.scatter = BondStrength::Scatter::weibull;
  wild.spread = {1e-300, 0};
  EXPECT_THAT(said_of(row(1, wild)), HasSubstr("none of 1000 draws with spread 1e-300"));
}

TEST(BondFailures, SayTheFirstTwentyOfManyFaults) {
  Model model = row(100, strength("musen", {5, not_given}));
  model.blocks[0].strength->overrides = {{1, std::vector<double>(100, -1)}};
  EXPECT_THAT(said_of(model), HasSubstr("and 80 more faults of this kind"));
}

}  // namespace
}  // namespace bondstatic
