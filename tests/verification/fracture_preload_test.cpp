// Loads that stay: what breaks by them alone, and what falls off with its weight.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "fracture/broken_model.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// Three equal bonds side by side between a held particle and one that the preload pulls, then the pattern by
/// 1 per unit of factor.
Model three_bonds(double kn, double preload) {
  Model model;
  add_particle(model, Vector3(0, 0, 0), 0.5);
  add_particle(model, Vector3(1, 0, 0), 0.5);
  model.blocks.push_back(block("generic", {{"kn", kn}, {"ks", kn}, {"kt", kn}, {"kb", kn}}));
  for (int i = 0; i < 3; ++i) add_bond(model, 0, 1);
  const StrengthCriterion& criterion = *find_strength_criterion("contact-bond");
  model.blocks[0].strength =
      strength("contact-bond", {{"critical_tensile_force", 1}, {"critical_shear_force", 1e9}});
  model.blocks[0].strength->overrides[std::size_t(criterion.find("critical_tensile_force"))] = {1, 4, 10};
  model.load_cases = {"pull", "hang"};
  fix_all(model, 0);
  load(model, 1, vector6(1, 0, 0), 0);
  load(model, 1, vector6(preload, 0, 0), 1);
  return model;
}

FractureOptions with_preload(FractureControl control = FractureControl::load) {
  FractureOptions options;
  options.preload = 1;
  options.control = control;
  return options;
}

TEST(FracturePreload, ThatAloneBreaksABondDoesSoAtFactorZero) {
  const double kn = 1e4, preload = 4.5;
  const Fracture found = fracture(three_bonds(kn, preload), with_preload(), one_thread());
  // 4.5 / 3 > 1, 4.5 / 2 < 4 = (4.5 + 3.5) / 2, 8 < 10 = 4.5 + 5.5.
  ASSERT_EQ(found.events.size(), 3u);
  const double factor[] = {0, 3.5, 5.5};
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_NEAR(found.events[e].factor, factor[e], 1e-14) << e;
    EXPECT_EQ(found.events[e].bonds[0].bond, Index(e));
    EXPECT_EQ(found.events[e].avalanche, Index(e) + 1);
  }
  EXPECT_NEAR(found.events[0].bonds[0].utilisation, 1.5, 1e-15);
  EXPECT_NEAR(found.events[0].runner_up, 1.5 / 4, 1e-15);
  // A break at the force q lets the ends part from q / k to where the others hold.
  EXPECT_NEAR(found.events[0].released * kn, 0.5 * 1.5 * 2.25, 1e-14);
  EXPECT_NEAR(found.events[1].released * kn, 0.5 * 4 * 8, 1e-13);
  // Counted from where the preload alone holds.
  EXPECT_NEAR(found.events[0].displacement, 0, 1e-18);
  EXPECT_NEAR(found.events[0].displacement_after * kn, 2.25 - 1.5, 1e-14);
  EXPECT_NEAR(found.events[1].displacement * kn, 4 - 1.5, 1e-14);
  EXPECT_EQ(found.end, FractureEnd::separated);
  EXPECT_LT(found.report.energy_balance, 1e-14);
}

TEST(FracturePreload, ThatBreaksAllDoesSoFromTheMostLoadedOn) {
  const Fracture found = fracture(three_bonds(1e4, 40), with_preload(), one_thread());
  ASSERT_EQ(found.events.size(), 3u);
  const double utilisation[] = {40.0 / 3, 20.0 / 4, 4};
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(found.events[e].factor, 0);
    EXPECT_EQ(found.events[e].avalanche, 1);
    EXPECT_NEAR(found.events[e].bonds[0].utilisation / utilisation[e], 1, 1e-14);
  }
  EXPECT_EQ(found.end, FractureEnd::separated);
}

/// A cantilever of two bonds, P on its tip; a chip hangs below it on a bond too weak for its weight.
TEST(FracturePreload, AChipThatFallsOffTakesItsWeightWithIt) {
  const double dead = 300, weight = 40;
  Model model = chain(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.1}}),
                      Vector3::Zero(), Vector3(2, 0, 0), 2, 0.3);
  const Index tip = 2, chip = add_particle(model, Vector3(2, 0, -1), 0.3);
  model.blocks.push_back(model.blocks[0]);
  add_bond(model, tip, chip, 1);
  model.blocks[1].strength =
      strength("contact-bond", {{"critical_tensile_force", 0.9 * weight}, {"critical_shear_force", 1e9}});
  model.load_cases = {"wind", "weight"};
  load(model, tip, vector6(0, 1, 0), 0);
  load(model, tip, vector6(0, 0, -dead), 1);
  load(model, chip, vector6(0, 0, -weight), 1);
  for (const FractureControl control : {FractureControl::load, FractureControl::event}) {
    const Fracture found = fracture(model, with_preload(control), one_thread());
    EXPECT_EQ(found.end, FractureEnd::unbreakable);
    ASSERT_EQ(found.events.size(), 1u);
    ASSERT_EQ(found.separated.size(), 1u);
    EXPECT_EQ(found.separated[0].particles, (std::vector<Index>{chip + 1}));
    EXPECT_EQ(found.events[0].factor, 0);
    // Without the weight, the tip swings up: compliance c gives c w^2 / 2, and the bond its own energy.
    Model probe = model;
    probe.load_cases = {"unit"};
    probe.loads.clear();
    load(probe, tip, vector6(0, 0, 1));
    const StaticSolution unit = solve_statics(probe, one_thread());
    const double c = unit.cases[0].displacement[std::size_t(tip)][2];
    const double kn = bond_properties(model)[2].stiffness.kn;
    const double released = weight * weight * (c + 1 / kn) / 2;
    EXPECT_NEAR(found.events[0].released / released, 1, 1e-12);
    EXPECT_NEAR(found.events[0].work / (-dead * weight * c), 1, 1e-12);  // the dead load is raised
    EXPECT_LT(found.report.energy_balance, 1e-13);
    const State fresh =
        solved_with_drop(broken_model(model, with_preload(control), found, 1, found.events[0].factor_after));
    EXPECT_LT(difference(found.last, fresh, found, 1).largest(), 1e-15);
  }
}

/// Heavy particles between a floor and a roof that is pulled: chips fall off, the rest goes on.
TEST(FracturePreload, AfterChipsHaveFallenEveryStateEqualsAPlainSolve) {
  std::mt19937_64 random(23);
  Model model =
      random_packing(random, 5, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}));
  model.load_cases = {"pull", "weight"};
  constexpr std::array<bool, 6> fixed{true, true, true, true, true, true};
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const double z = model.particles[p].position.z();
    load(model, Index(p), vector6(0, 0, -1e4), 1);
    if (z < 0.5) fix_all(model, Index(p));
    if (z < 3.5) continue;
    model.supports.push_back({Index(p), fixed, vector6(0.3, 0, 1), 0});
    model.supports.push_back({Index(p), fixed, Vector6::Zero(), 1});
  }
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 2e6}});
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {1, 1};
  for (const FractureControl control : {FractureControl::displacement, FractureControl::event}) {
    const FractureOptions options = with_preload(control);
    const WatchedRun run = watched(model, options, one_thread());
    EXPECT_EQ(run.found.end, FractureEnd::separated);
    ASSERT_GT(run.found.separated.size(), 2u);
    const std::size_t last = run.found.separated.back().event;
    ASSERT_LT(run.found.separated.front().event + 20, last);
    for (std::size_t e = run.found.separated.front().event; e < run.states.size(); e += 5) {
      const State fresh =
          solved_with_drop(broken_model(model, options, run.found, e, run.found.events[e].factor));
      EXPECT_LT(difference(run.states[e], fresh, run.found, e).largest(), 1e-14) << e;
    }
    for (const FractureEvent& event : run.found.events) EXPECT_GE(event.released, 0);
    EXPECT_LT(run.found.report.energy_balance, 1e-13);
  }
}

}  // namespace
}  // namespace bondstatic::test
