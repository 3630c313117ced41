// The relaxed state as the start of a DEM run: without a settling transient. The explicit run stands in for
// another code: it takes the exported state in its first step, bonds from their reference state, and is at
// rest from there on.
#include <gtest/gtest.h>

#include "bondstatic/dynamics.hpp"
#include "formats/export_models.hpp"
#include "formats/readers.hpp"
#include "model/turning.hpp"

namespace bondstatic::test {
namespace {

/// Motion of each particle that the exported dump tells, from its own numbers.
std::vector<Vector6> exported_motion(const Model& model) {
  const Exported exported(model, "lammps", true);
  std::vector<Fault> faults;
  const auto state = read_particle_state(exported.path("dump.static"), {}, {}, faults);
  for (const Fault& fault : faults) ADD_FAILURE() << to_string(fault);
  std::vector<Vector6> motion;
  for (std::size_t p = 0; state && p < model.particles.size(); ++p) {
    EXPECT_EQ(state->id[p], model.particles[p].id);
    Vector6 u;
    u << state->position[p] - model.particles[p].position, rotation_vector(state->orientation[p]);
    motion.push_back(u);
  }
  return motion;
}

/// Unbalanced force over that of loads and reactions after the step that takes the model there.
double unbalanced_at_start(const Model& model, Kinematics kinematics) {
  const std::vector<Vector6> motion = exported_motion(model);
  DynamicOptions options;
  options.kinematics = kinematics;
  options.time_step = 1e-7;
  options.ramp_time = options.time_step;  // the full load when the state is there
  ExplicitRun run(model, bond_properties(model), 0, {}, options);
  for (std::size_t p = 0; p < motion.size(); ++p) run.set_velocity(Index(p), motion[p] / options.time_step);
  run.advance(1);
  return run.unrest().unbalanced;
}

Model loaded_by(double factor) {
  Model model = mixed_model();
  for (Load& load : model.loads) load.force *= factor;
  return model;
}

TEST(RelaxedStart, IsInBalanceFromTheFirstStep) {
  EXPECT_LT(unbalanced_at_start(loaded_by(1), Kinematics::small), 1e-10);
}

TEST(RelaxedStart, WithFiniteKinematicsIsOffByTermsOfSecondOrderOnly) {
  const double whole = unbalanced_at_start(loaded_by(1), Kinematics::finite);
  const double half = unbalanced_at_start(loaded_by(0.5), Kinematics::finite);
  EXPECT_LT(whole, 1e-2);
  EXPECT_NEAR(whole / half, 2, 0.02);
}

TEST(RelaxedStart, TheReferenceStateIsNotInBalance) {
  const Model model = mixed_model();
  DynamicOptions options;
  options.time_step = 1e-7;
  ExplicitRun run(model, bond_properties(model), 0, {}, options);
  run.advance(1);
  EXPECT_GT(run.unrest().unbalanced, 0.1);
}

}  // namespace
}  // namespace bondstatic::test
