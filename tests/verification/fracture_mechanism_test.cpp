// Where breaking leaves something that moves freely: inside the model it is the end, a chip that supports
// hold in part falls off.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bondstatic/mechanism.hpp"
#include "fracture/broken_model.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// Face-centred cubic, 4 planes of nodes along each axis, bonds without moments; pulled at the roof.
Model contact_lattice() {
  Model model;
  model.blocks.push_back(block("contact", {{"kn", 1e6}, {"ks", 5e5}}));
  for (int n = 0; n < 216; ++n)
    if ((n % 6 + n / 6 % 6 + n / 36) % 2 == 0) add_particle(model, Vector3(n % 6, n / 6 % 6, n / 36), 0.7);
  bond_within(model, 1.5);
  const Index count = Index(model.particles.size());
  for (Index p = 0; p < count; ++p) {
    const double z = model.particles[std::size_t(p)].position.z();
    if (z < 0.5) fix_all(model, p);
    if (z > 4.5) fix_all(model, p, vector6(0, 0, 1));
  }
  model.blocks[0].strength =
      strength("contact-bond", {{"critical_tensile_force", 1}, {"critical_shear_force", 1}});
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {2, 2};
  return model;
}

TEST(FractureMechanism, ALatticeWithoutMomentsBreaksUntilAPartTurnsFreely) {
  const Model model = contact_lattice();
  const WatchedRun run = watched(model, {}, one_thread());
  ASSERT_EQ(run.found.end, FractureEnd::mechanism) << text_of(run.found.end) << run.found.reason;
  ASSERT_GT(run.found.events.size(), 10u);
  EXPECT_NE(run.found.reason.find("particle"), std::string::npos) << run.found.reason;
  EXPECT_NE(run.found.reason.find("free to"), std::string::npos) << run.found.reason;
  const std::size_t last = run.found.events.size() - 1;
  for (std::size_t e = 0; e <= last; e += 5)
    EXPECT_LT(difference(run.states[e],
                         solved_with_drop(broken_model(model, {}, run.found, e, run.found.events[e].factor)),
                         run.found, e)
                  .largest(),
              1e-13)
        << e;
  // A plain solve of what is left then refuses for the same reason; the state found is that before.
  try {
    solved_with_drop(broken_model(model, {}, run.found, last + 1, 1));
    FAIL();
  } catch (const MechanismError& error) {
    EXPECT_NE(std::string(error.what()).find(run.found.reason), std::string::npos) << error.what() << "\n"
                                                                                   << run.found.reason;
  }
  EXPECT_TRUE(std::isnan(run.found.events[last].released));
  const State before =
      solved_with_drop(broken_model(model, {}, run.found, last, run.found.events[last].factor));
  EXPECT_LT(difference(run.found.last, before, run.found, last).largest(), 1e-13);
}

/// A chip of two on a platen that lets it roll and slide, at one weak bond to a chain that is bent.
TEST(FractureMechanism, AChipThatAPlatenHoldsInPartFallsOff) {
  Model model = chain(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(8, 0, 0), 8, 0.5);
  model.blocks.push_back(model.blocks[0]);
  const Index chip = add_particle(model, Vector3(4, 0, -1), 0.5),
              foot = add_particle(model, Vector3(5, 0, -1), 0.5);
  add_bond(model, 4, chip, 1);
  add_bond(model, chip, foot, 0);
  model.supports.push_back({foot, {false, false, true, false, false, false}, Vector6::Zero(), every_case});
  load(model, 8, vector6(0, 0, -1));
  for (const double critical : {2e3, 1e7})
    model.blocks[critical < 1e4].strength =
        strength("edem-v2", {{"critical_normal_stress", critical}, {"critical_shear_stress", 1e9}});
  const Fracture found = fracture(model, {}, one_thread());
  ASSERT_EQ(found.separated.size(), 2u);  // the second is what the root held, at the end
  EXPECT_EQ(found.separated[0].particles, (std::vector<Index>{chip + 1, foot + 1}));
  EXPECT_EQ(found.separated[0].event, 0u);
  ASSERT_EQ(found.events.size(), 2u);
  EXPECT_EQ(found.events[0].bonds[0].bond, 8);
  EXPECT_EQ(found.events[1].bonds[0].bond, 0);  // the root of what is a cantilever now
  EXPECT_EQ(found.end, FractureEnd::separated);
  EXPECT_LT(found.report.energy_balance, 1e-13);
  EXPECT_TRUE(std::isnan(found.last.displacement[std::size_t(chip)][0]));
  // Closed form: the arm is from the tip to the middle of the root's bond.
  const double inertia_over_radius = 3.141592653589793 * 0.008 / 4;
  EXPECT_NEAR(found.events[1].factor / (1e7 * inertia_over_radius / 7.5), 1, 1e-13);
}

}  // namespace
}  // namespace bondstatic::test
