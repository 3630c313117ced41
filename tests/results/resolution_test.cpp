#include "bondstatic/resolution.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bondstatic/statics.hpp"
#include "results/bond_beam.hpp"
#include "results/bond_rows.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double pi = 3.14159265358979323846;

// [Chen2022] section 3: E = 200 GPa, nu = 0.3, r = 0.2 m, 4 m long, 100 kN across the tip.
constexpr double young = 200e9, poisson = 0.3, radius = 0.2, total = 4, force = 100e3;

double beam_theory() {  // Eq. 29
  const double area = pi * radius * radius, second_moment = area * radius * radius / 4;
  const double shear_modulus = young / (2 * (1 + poisson));
  return force * total * total * total / (3 * young * second_moment) +
         10 * force * total / (9 * shear_modulus * area);
}

Model row(const std::string& law, const Values& more, Index bonds, ContactPoint point = {}) {
  Values values{{"young", young}, {"radius", radius}};
  values.insert(values.end(), more.begin(), more.end());
  Model model =
      chain(block(law, values, point), Vector3::Zero(), Vector3(0.6, 0.64, 0.48) * total, bonds, radius);
  Vector6 end = Vector6::Zero();
  end.head<3>() = force * Vector3(0.64, -0.6, 0).normalized();
  load(model, bonds, end);
  return model;
}

double solved_error(const Model& model) {
  return solve_statics(model, {}).cases[0].displacement.back().head<3>().norm() / beam_theory() - 1;
}

/// Of the only block.
BlockResolution only(const Model& model, double assumed = assumed_poisson) {
  const auto blocks = resolution_of(model, 1, assumed);
  EXPECT_EQ(blocks.size(), 1u);
  return blocks.empty() ? BlockResolution{} : blocks.front();
}

/// All bonds have this, within `tolerance`.
void expect_all(const Spread& spread, double value, double tolerance) {
  for (const double one :
       {spread.smallest, spread.lower_quartile, spread.median, spread.upper_quartile, spread.largest})
    EXPECT_NEAR(one, value, tolerance);
}

TEST(ResolutionOfTheParallelBond, IsThePapersCase3) {
  const std::pair<Index, double> percent[] = {{1, -24.92}, {2, -6.27},  {4, -1.61},
                                              {6, -0.745}, {8, -0.442}, {10, -0.303}};
  for (const auto& [n, expected] : percent) {
    const BlockResolution block = only(row("parallel", {{"poisson", poisson}}, n));
    expect_all(block.deflection, expected / 100, n < 5 ? 5e-5 : 5e-6);
    expect_all(block.row, double(n), 0);
    expect_all(block.slenderness, 10.0 / double(n), 1e-14);
    EXPECT_EQ(block.coarse, n <= 4 ? 1 : 0);
  }
}

TEST(ResolutionOfTheParallelBond, SaysHowManyTimesTooStiffTheBondsAre) {
  // [Chen2022] section 4.1: 52 times with one bond, 1.6 times with ten; Euler-Bernoulli 3.1 (3.17, truncated)
  EXPECT_NEAR(1 + only(row("parallel", {{"poisson", poisson}}, 1)).transverse.median, 52, 0.5);
  EXPECT_NEAR(1 + only(row("parallel", {{"poisson", poisson}}, 10)).transverse.median, 1.6, 0.05);
  EXPECT_NEAR(1 + only(row("euler-bernoulli", {{"poisson", poisson}}, 10)).transverse.median, 3.167, 5e-4);
}

TEST(ResolutionOfEulerBernoulli, IsTheSameForAnyNumberOfBonds) {
  for (const Index n : {1, 2, 7}) {
    const BlockResolution block = only(row("euler-bernoulli", {{"poisson", poisson}}, n));
    expect_all(block.deflection, -0.00539, 5e-6);
    EXPECT_THAT(block.advice, Contains(HasSubstr("other lengths")));
    const double phi = 5 * (1 + poisson) * double(n * n) / (3 * 100);
    expect_all(block.single, -phi / (4 + phi), 1e-15);
    expect_all(block.transverse, phi, 1e-12);
  }
}

struct Law {
  const char* name;
  Values more;
};

class Rows : public testing::TestWithParam<Law> {};

TEST_P(Rows, AreOffByWhatIsPredicted) {
  for (const Index n : {1, 2, 3, 10, 25}) {
    const Model model = row(GetParam().name, GetParam().more, n);
    expect_all(only(model, poisson).deflection, solved_error(model), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Rows,
                         testing::Values(Law{"parallel", {{"poisson", poisson}}},
                                         Law{"parallel", {{"kappa", 7}}},
                                         Law{"euler-bernoulli", {{"poisson", poisson}}},
                                         Law{"obermayr", {{"poisson", poisson}}},
                                         Law{"obermayr", {{"poisson", poisson}, {"shear_coefficient", 0.5}}}),
                         [](const auto& one) {
                           std::string name = std::string(one.param.name) + std::to_string(one.index);
                           std::erase(name, '-');
                           return name;
                         });

TEST(Rows, OfStiffnessPerAreaAreOffByWhatIsPredicted) {
  for (const Index n : {1, 4}) {
    const double length = total / double(n);
    const Values pfc{
        {"normal_stiffness", young / length}, {"shear_stiffness", young / length / 2.6}, {"radius", radius}};
    const Values edem{{"normal_stiffness", young / length},
                      {"shear_stiffness", young / length / 2.6},
                      {"torque_feedback", 1}};
    for (const BondBlock& law : {block("pfc-parallel", pfc), block("edem-v2", edem)}) {
      Model model = row("parallel", {{"poisson", poisson}}, n);
      model.blocks[0] = law;
      const BlockResolution found = only(model, poisson);
      expect_all(found.deflection, solved_error(model), 1e-12);
      EXPECT_EQ(found.poisson_assumed, n);
      EXPECT_THAT(found.advice, Contains(HasSubstr("young = 2e+11")));
    }
  }
}

// Particles small and large in turn: case 5, and the same row held at its other end.
Model case5(double middle, Index bonds, const Values& more, const std::string& law = "parallel",
            ContactPoint point = {}) {
  Model model = row(law, more, bonds, point);
  for (Index p = 1; p <= bonds; p += 2) model.particles[std::size_t(p)].radius = middle;
  return model;
}

TEST(ResolutionOfUnequalParticles, IsThePapersCase5) {
  // The paper holds it at a small particle, towards which the contact points move.
  const std::pair<double, double> percent[] = {{0.2, -0.54}, {0.4, 3.38}, {0.8, 12.33}};
  for (const auto& [middle, expected] : percent) {
    const BlockResolution block = only(case5(middle, 2, {{"kappa", 100.0 / 3}}), poisson);
    EXPECT_NEAR(block.deflection.largest, expected / 100, 5e-5);
    expect_all(block.offset, (middle - 0.2) / 4, 1e-15);
    EXPECT_EQ(block.poisson_assumed, 2);
  }
}

TEST(ResolutionOfUnequalParticles, KnowsBothEndsToHold) {
  for (const Index n : {1, 2, 3, 6})
    for (const double kappa : {0.5, 40.0}) {
      const Model small_held = case5(0.25, n, {{"kappa", kappa}});
      Model large_held = small_held;
      for (Particle& p : large_held.particles) p.radius = p.radius == 0.25 ? 0.2 : 0.25;
      const BlockResolution block = only(small_held, poisson);
      EXPECT_NEAR(block.deflection.largest, solved_error(small_held), 1e-12);
      EXPECT_NEAR(block.deflection.smallest, solved_error(large_held), 1e-12);
      EXPECT_EQ(only(large_held, poisson).deflection.largest, block.deflection.largest);
    }
}

TEST(ResolutionOfTimoshenko, IsSaidOnlyWhereTheContactPointIsNotItsOwn) {
  EXPECT_THAT(resolution_of(case5(0.4, 2, {{"poisson", poisson}}, "timoshenko")), IsEmpty());
  const ContactPoint gap{ContactPoint::Kind::gap};
  const Model model = case5(0.4, 2, {{"poisson", poisson}}, "timoshenko", gap);
  const BlockResolution block = only(model);
  EXPECT_NEAR(block.deflection.largest, solved_error(model), 1e-12);
  EXPECT_THAT(block.advice, ElementsAre(HasSubstr("contact_point = \"beam\"")));
}

TEST(ExactKappa, GivesTimoshenkosDeflectionWithAnyNumberOfBonds) {
  for (const Index n : {1, 2, 5, 10}) {
    const BlockResolution coarse = only(row("parallel", {{"poisson", poisson}}, n));
    const double lambda = 10.0 / double(n), kappa = 4 * lambda * lambda / 3 + 20 * (1 + poisson) / 9;
    expect_all(coarse.beam_kappa, kappa, 1e-12 * kappa);
    const Model model = row("parallel", {{"kappa", coarse.beam_kappa.median}}, n);
    EXPECT_NEAR(solved_error(model), 0, 1e-13);
    expect_all(only(model, poisson).deflection, 0, 1e-14);
    // What is gained across the axis is lost about it.
    expect_all(only(model, poisson).twisting, 2 * (1 + poisson) / kappa - 1, 1e-14);
  }
}

TEST(ExactShearCoefficient, GivesTimoshenkosDeflection) {
  const BlockResolution block = only(row("obermayr", {{"poisson", poisson}}, 2));
  const double coefficient = 2 * (1 + poisson) / block.beam_kappa.median;
  EXPECT_THAT(block.advice, Contains(HasSubstr(fmt::format("{:.8g}", coefficient))));
  EXPECT_NEAR(solved_error(row("obermayr", {{"poisson", poisson}, {"shear_coefficient", coefficient}}, 2)), 0,
              1e-13);
}

TEST(BondsForATolerance, AreTheFewestThatKeepIt) {
  for (const double slenderness : {0.4, 1.0, 3.0, 20.0})
    for (const double kappa : {0.3, 2.6, 30.0, 500.0})
      for (const double offset : {0.0, 0.1}) {
        const BondBeam bond{slenderness, kappa, 0.2, offset};
        const double n = bonds_for_tolerance(bond, 0.01);
        const auto error = [&](double m) {
          const BondBeam turned{slenderness, kappa, 0.2, -offset};
          return std::max(std::abs(deflection_error(bond, m)), std::abs(deflection_error(turned, m)));
        };
        EXPECT_LE(error(n), 0.01 * (1 + 1e-14));
        if (n > 1) {
          EXPECT_GT(error(n - 1), 0.01);
        }
      }
}

TEST(HalvingTheBonds, HasTheErrorThatItPromises) {
  for (const Index n : {1, 3}) {
    const BlockResolution block = only(row("parallel", {{"poisson", poisson}}, n));
    const BondBeam bond{block.slenderness.median, block.kappa.median, poisson, 0};
    EXPECT_NEAR(halved_error(bond, double(n)), solved_error(row("parallel", {{"poisson", poisson}}, 2 * n)),
                1e-12);
    EXPECT_THAT(block.advice, Contains(HasSubstr("half as long")));
  }
}

TEST(Bonds, KnowTheirOwnPoissonRatio) {
  Model model = row("parallel", {{"poisson", poisson}}, 4);
  BondBlock& bonds = model.blocks[0];
  const auto kappa = std::size_t(find_bond_law("parallel")->find("kappa"));
  const auto nu = std::size_t(find_bond_law("parallel")->find("poisson"));
  bonds.overrides[kappa] = {not_given, 3, not_given, not_given};
  bonds.overrides[nu] = {not_given, not_given, 0.1, not_given};
  const BlockResolution block = only(model, 0.4);
  EXPECT_EQ(block.poisson_assumed, 1);
  EXPECT_NEAR(block.poisson.smallest, 0.1, 1e-15);
  EXPECT_NEAR(block.poisson.median, 0.3, 1e-15);
  EXPECT_NEAR(block.poisson.largest, 0.4, 1e-15);
  EXPECT_NEAR(block.twisting.smallest, 2 * 1.4 / 3 - 1, 1e-15);
  EXPECT_EQ(block.twisting.largest, 0);
}

TEST(Spreads, AreValuesOfSingleBondsByRank) {
  // Bonds of lengths 1, 2, 3, 4, 5 in one row.
  Model model;
  model.blocks.push_back(block("parallel", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.5}}));
  double x = 0;
  add_particle(model, Vector3::Zero(), 0.5);
  for (const double length : {4, 2, 5, 1, 3}) {
    add_particle(model, Vector3(x += length, 0, 0), 0.5);
    add_bond(model, Index(model.bonds.size()), Index(model.bonds.size()) + 1);
  }
  const Spread lambda = only(model).slenderness;
  EXPECT_EQ(lambda.smallest, 1);
  EXPECT_EQ(lambda.lower_quartile, 2);
  EXPECT_EQ(lambda.median, 3);
  EXPECT_EQ(lambda.upper_quartile, 4);
  EXPECT_EQ(lambda.largest, 5);
}

TEST(UnbranchedRows, EndWhereBondsBranch) {
  // 0-1-2-3 with 3-4 and 3-5-6, and a ring 7-8-9
  Model model;
  for (int p = 0; p < 10; ++p) add_particle(model, Vector3(p, p * p, 0), 0.1);
  const std::pair<Index, Index> pairs[] = {{0, 1}, {2, 1}, {2, 3}, {3, 4}, {3, 5},
                                           {6, 5}, {7, 8}, {8, 9}, {9, 7}};
  for (const auto& [a, b] : pairs) add_bond(model, a, b);
  const UnbranchedRows rows = bond_rows(model);
  EXPECT_THAT(rows.length, ElementsAre(3, 3, 3, 1, 2, 2, 3, 3, 3));
  EXPECT_THAT(rows.unbranched, ElementsAre(true, true, false, false, false, true, true, true, true));
}

TEST(Packings, AreNoRowsAndGetNoAdviceOnLength) {
  std::mt19937_64 random(3);
  const Model model = random_packing(random, 4, block("parallel", {{"young", 1e9}, {"poisson", 0.2}}));
  const BlockResolution found = only(model);
  EXPECT_FALSE(found.is_of_rows());
  EXPECT_EQ(found.bonds, Index(model.bonds.size()));
  EXPECT_EQ(found.row.largest, 1);
  EXPECT_GT(found.offset.largest, 0.01);
  EXPECT_THAT(found.advice, AllOf(Contains(HasSubstr("timoshenko")), Contains(HasSubstr("kappa")),
                                  Each(Not(HasSubstr("half as long")))));
  Index coarse = 0;
  for (const Bond& bond : model.bonds) {
    const BondSite site = bond_site(model, bond);
    const double r = std::min(site.radius_a, site.radius_b);
    const double offset = std::abs(site.radius_a - site.radius_b) / (2 * site.length);
    const auto error = [&](double d) { return deflection_error({site.length / (2 * r), 2.4, 0.2, d}, 1); };
    coarse += std::max(std::abs(error(offset)), std::abs(error(-offset))) > 0.01;
  }
  EXPECT_EQ(found.coarse, double(coarse) / double(found.bonds));
}

TEST(Resolution, IsOfEachBlockThatItKnows) {
  Model model = row("parallel", {{"poisson", poisson}}, 5);
  model.blocks.push_back(block("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", radius}}));
  model.blocks.push_back(block("generic", {{"kn", 1e9}, {"ks", 1e9}, {"kt", 1e6}, {"kb", 1e6}}));
  model.blocks.push_back(
      block("edem-v2", {{"normal_stiffness", 1e9}, {"shear_stiffness", 1e9}, {"torque_feedback", 0}}));
  model.blocks.push_back(block("obermayr", {{"young", young}, {"poisson", poisson}, {"radius", radius}}));
  for (std::size_t k = 0; k < 5; ++k) model.bonds[k].block = Index(k), model.bonds[k].in_block = 0;
  const auto blocks = resolution_of(model);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].law, "parallel");
  EXPECT_EQ(blocks[1].law, "obermayr");
  EXPECT_EQ(blocks[1].block, 4);
  EXPECT_EQ(blocks[1].bonds, 1);
}

}  // namespace
}  // namespace bondstatic::test
