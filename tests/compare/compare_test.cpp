#include "bondstatic/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/dynamics.hpp"
#include "compare/response.hpp"
#include "compare/runs.hpp"
#include "support/periodic.hpp"

namespace bondstatic {

namespace {

using test::compared;
using test::ended_in;
using test::kb;
using test::kn;
using test::ks;
using test::kt;
using test::packing;
using test::static_state;
using testing::HasSubstr;

/// The reason names this alone, and the best suspect of that name has this factor.
void expect_suspect(const Comparison& c, const std::string& what, double factor, double tolerance) {
  EXPECT_EQ(c.verdict, CompareVerdict::different_model) << c.reason;
  ASSERT_FALSE(c.suspects.empty());
  for (const Suspect& suspect : c.suspects) {
    if (suspect.what == "each stiffness") continue;
    EXPECT_EQ(suspect.what, what) << c.reason;
    EXPECT_NEAR(suspect.factors.at(0), factor, tolerance) << c.reason;
    EXPECT_THAT(c.reason, HasSubstr(suspect.text));
    return;
  }
}

DynamicOptions damped(double damping, double time_step) {
  DynamicOptions options;
  options.particle_damping = damping;
  options.time_step = time_step;
  return options;
}

TEST(Compare, TheStaticAnswerIsTheSameState) {
  const Model model = packing();
  const Comparison c = compared(model, ended_in(static_state(model)));
  EXPECT_EQ(c.verdict, CompareVerdict::same_state);
  for (const FieldComparison& field : c.fields) EXPECT_LE(field.difference, 1e-15) << field.field;
  EXPECT_EQ(c.fields[0].field, "displacement");
  EXPECT_NEAR(c.fields[0].scale, 1, 1e-15);
  EXPECT_LE(c.unbalance.linear, 1e-11);
}

TEST(Compare, FieldsSayHowMuchAndWhere) {
  const Model model = packing();
  const State statics = static_state(model);
  RunState run = ended_in(statics);
  for (Vector6& u : run.displacement) u *= 1.0005;
  run.displacement[40].y() += 0.1;
  const Comparison c = compare(model, statics, 0, run, test::direct(), {1e-3, false});
  double norm = 0, all = 0;
  for (std::size_t p = 0; p < run.displacement.size(); ++p) {
    norm += (run.displacement[p] - statics.displacement[p]).head<3>().squaredNorm();
    all += statics.displacement[p].head<3>().squaredNorm();
  }
  EXPECT_NEAR(c.fields[0].difference, std::sqrt(norm / all), 1e-12 * std::sqrt(norm / all));
  EXPECT_EQ(c.fields[0].at, 40);
  EXPECT_EQ(c.worst.front().particle, 40);
  EXPECT_EQ(c.worst.size(), 10u);
  EXPECT_EQ(c.worst.front().run, run.displacement[40]);
  EXPECT_NEAR(c.fields[1].scale, 1.0005, 1e-12);
  EXPECT_LE(c.fields[1].misfit, 1e-12);
}

TEST(Compare, NamesAStiffnessThatIsAnotherOne) {
  const Model model = packing();
  expect_suspect(
      compared(model,
               ended_in(static_state(packing({{"kn", kn}, {"ks", 0.97 * ks}, {"kt", kt}, {"kb", kb}})))),
      "shear stiffness", 0.97, 1e-4);
  expect_suspect(
      compared(model, ended_in(static_state(packing({{"kn", 2 * kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}})))),
      "normal stiffness", 2, 1e-3);
  expect_suspect(
      compared(model,
               ended_in(static_state(packing({{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", 0.5 * kb}})))),
      "bending stiffness", 0.5, 1e-3);
}

TEST(Compare, NamesACommonFactorAsStiffnessOrLoads) {
  Model model = packing();
  const State run = static_state(model);
  for (Load& load : model.loads) load.force /= 1.02;
  const Comparison c = compared(model, ended_in(run));
  expect_suspect(c, "all stiffness or all loads", 1 / 1.02, 1e-5);
  EXPECT_THAT(c.reason, HasSubstr("all loads 1.02 times"));
}

TEST(Compare, NamesSeveralStiffnessesOnlyWhereOneDoesNotDo) {
  const Comparison c =
      compared(packing(),
               ended_in(static_state(packing({{"kn", 1.1 * kn}, {"ks", 0.8 * ks}, {"kt", kt}, {"kb", kb}}))));
  EXPECT_EQ(c.verdict, CompareVerdict::different_model);
  EXPECT_EQ(c.suspects.front().what, "each stiffness");
  EXPECT_NEAR(c.suspects.front().factors[0], 1.1, 1e-3);
  EXPECT_NEAR(c.suspects.front().factors[1], 0.8, 1e-3);
  EXPECT_THAT(c.reason, HasSubstr(c.suspects.front().text));
}

TEST(Compare, NamesTheContactPoint) {
  const test::Values stiffness{{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}};
  const Model gap = packing(stiffness, {ContactPoint::Kind::gap, 0});
  const Model beam = packing(stiffness, {ContactPoint::Kind::beam, 0});
  const Model radii = packing(stiffness, {ContactPoint::Kind::contact_radii, 1.3});
  const Comparison c = compared(beam, ended_in(static_state(gap)));
  expect_suspect(c, "contact point", 1, 1e-3);
  EXPECT_THAT(c.reason, HasSubstr("\"gap\""));
  expect_suspect(compared(gap, ended_in(static_state(beam))), "contact point", 0, 1e-3);
  expect_suspect(compared(beam, ended_in(static_state(radii))), "contact point", 1.3, 1e-3);
}

TEST(Compare, KnowsSupportsThatMovedOtherwise) {
  Model model = packing();
  for (Support& support : model.supports)
    if (support.particle < 8) support.value.z() = -2e-6;
  const State run = static_state(model);
  const Comparison c = compared(packing(), ended_in(run));
  EXPECT_EQ(c.verdict, CompareVerdict::different_model);
  EXPECT_THAT(c.reason, HasSubstr("supported particles are elsewhere"));
}

/// The state of the model with so much of its slowest mode added.
RunState swinging(const Model& model, const State& statics, double amplitude) {
  const BondNetwork network = bond_network(model, bond_properties(model));
  Response response(model, network, boundary_of(model, 0), test::direct());
  const auto modes = response.lowest_modes(body_masses(model), 3);
  double size = 0, shape = 0;
  for (std::size_t p = 0; p < statics.displacement.size(); ++p) {
    size += statics.displacement[p].squaredNorm();
    shape += modes[1].shape[p].squaredNorm();
  }
  RunState run = ended_in(statics);
  for (std::size_t p = 0; p < run.displacement.size(); ++p)
    run.displacement[p] += amplitude * std::sqrt(size / shape) * modes[1].shape[p];
  return run;
}

TEST(Compare, ASlowModeIsStillMoving) {
  const Model model = packing();
  const Comparison c = compared(model, swinging(model, static_state(model), 0.02));
  EXPECT_EQ(c.verdict, CompareVerdict::still_moving) << c.reason;
  EXPECT_GE(c.unbalance.slow_modes, 0.99);
}

TEST(Compare, VelocitiesAndNetForcesTellThatItMoves) {
  const Model model = packing();
  const State statics = static_state(model);
  ExplicitRun run(model, bond_properties(model), 0, std::vector<bool>(model.particles.size(), false),
                  damped(0.2, 1e-3));
  run.advance(200);
  RunState early = ended_in(run.state());
  const Comparison blind = compared(model, early);
  EXPECT_NE(blind.verdict, CompareVerdict::same_state);
  EXPECT_NE(blind.verdict, CompareVerdict::different_model) << blind.reason;

  RunState with_forces = early, with_velocities = early;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    with_velocities.velocity.push_back(run.velocity(Index(p)));
    with_forces.net_force.push_back(run.bond_force(Index(p)));
  }
  for (const Load& load : model.loads) with_forces.net_force[std::size_t(load.particle)] += load.force;
  const Comparison moving = compared(model, with_velocities), pushed = compared(model, with_forces);
  EXPECT_EQ(moving.verdict, CompareVerdict::still_moving);
  EXPECT_THAT(moving.reason, HasSubstr("kinetic energy"));
  EXPECT_EQ(pushed.verdict, CompareVerdict::still_moving);
  EXPECT_NEAR(pushed.unbalance.moving_part, 1, 1e-3);
}

TEST(Compare, AStateOnItsWayThroughIsNotAtRest) {
  const Model model = packing();
  RunState run = ended_in(static_state(model));
  run.velocity.assign(model.particles.size(), test::vector6(1e-5, 0, 0));
  EXPECT_EQ(compared(model, run).verdict, CompareVerdict::still_moving);
}

TEST(Compare, FiniteRotationsAreNotAnotherModel) {
  // 0.05 of its length: linear and finite kinematics part by a few per cent.
  Model model = test::chain(test::block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.1}}),
                            {0, 0, 0}, {4, 0, 0}, 8, 0.2);
  for (Particle& particle : model.particles) particle.density = 2000;
  test::load(model, 8, test::vector6(0, -700, 0));
  ExplicitRun run(model, bond_properties(model), 0, std::vector<bool>(9, false), damped(0.8, 1.5e-4));
  run.advance(100000);
  ASSERT_LE(run.unrest().unbalanced, 1e-6);
  const Comparison c = compared(model, ended_in(run.state()));
  EXPECT_GE(c.fields[0].difference, 2e-3);
  EXPECT_EQ(c.verdict, CompareVerdict::same_state) << c.reason;
  EXPECT_THAT(c.reason, HasSubstr("finite rotations"));
}

TEST(Compare, InAPeriodicCellTheStrainCounts) {
  const auto strained = [](double shear) {
    std::mt19937_64 random(5);
    Model model = test::periodic_packing(
        random, 3, test::block("generic", {{"kn", kn}, {"ks", shear}, {"kt", kt}, {"kb", kb}}));
    for (Strain& strain : model.strains) strain.value *= 1e-6;
    return model;
  };
  const Model model = strained(ks), other = strained(0.9 * ks);
  const auto statics = solve_statics(model, test::direct()).cases;
  const auto others = solve_statics(other, test::direct()).cases;
  for (const Index load_case : {0, 4}) {
    const auto at = std::size_t(load_case);
    const auto ends_in = [&](const State& state) {
      return compare(model, statics[at], load_case, ended_in(state), test::direct());
    };
    const Comparison same = ends_in(statics[at]);
    EXPECT_EQ(same.verdict, CompareVerdict::same_state);
    EXPECT_NEAR(same.fields.back().run_norm, statics[at].energy, 1e-12 * statics[at].energy);
    EXPECT_LE(same.unbalance.finite, 1e-4);
    const Comparison apart =
        compare(model, statics[at], load_case, ended_in(others[at]), test::direct(), {1e-4, true});
    expect_suspect(apart, "shear stiffness", 0.9, 2e-3);
  }
}

TEST(Compare, WithoutRotationsDisplacementsAreExplained) {
  const Model model = packing();
  RunState run = ended_in(static_state(packing({{"kn", 1.2 * kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}})));
  run.has_rotations = false;
  for (Vector6& u : run.displacement) u.tail<3>().setConstant(not_given);
  const Comparison c = compared(model, run);
  EXPECT_EQ(c.verdict, CompareVerdict::different_model) << c.reason;
  EXPECT_THAT(c.reason, HasSubstr("normal stiffness 1.2"));
}

}  // namespace

}  // namespace bondstatic
