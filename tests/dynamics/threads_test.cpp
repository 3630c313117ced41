// Same bits at any number of threads, and after going out to a text and in again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"
#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

/// Large enough that threads share the work, with every kind of thing that moves.
Model large_packing(int edge = 8) {
  std::mt19937_64 random(31);
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  std::uniform_real_distribution<double> density(2000, 3000);
  for (Particle& particle : model.particles) particle.density = density(random);
  for (Index p = 0; p < edge * edge; ++p) fix_all(model, p);
  const Index last = Index(model.particles.size()) - 1;
  load(model, last, vector6(1e4, -2e4, 3e4, 1e3, 2e3, 3e3));
  fix_all(model, last - 5, vector6(1e-3, 0, -1e-3, 0, 1e-3, 0));
  return model;
}

struct Kind {
  Kinematics kinematics;
  bool dashpots;
};

class SameBits : public ::testing::TestWithParam<Kind> {
 protected:
  static constexpr Index steps = 70;

  DynamicOptions options(int threads) const {
    DynamicOptions result;
    result.kinematics = GetParam().kinematics;
    result.particle_damping = 0.3;
    if (GetParam().dashpots) result.bond_damping = {.paper = 0.01, .normal = 0.02, .bending = 0.03};
    result.time_step = 2e-5;
    result.ramp = Ramp::smooth;
    result.ramp_time = 40 * result.time_step;
    result.threads = threads;
    return result;
  }
};

TEST_P(SameBits, AtAnyNumberOfThreads) {
  const Model model = large_packing();
  ASSERT_GT(model.bonds.size(), 1000u);
  ExplicitRun one = explicit_run(model, options(1));
  one.advance(steps);
  const std::string expected = one.save();
  for (const int threads : {2, 3, 4}) {
    SCOPED_TRACE(threads);
    ExplicitRun at_once = explicit_run(model, options(threads));
    at_once.advance(steps);
    EXPECT_TRUE(at_once.save() == expected);
    EXPECT_EQ(at_once.energies().balance(), one.energies().balance());
    // A run tries its threads in its first steps; whether it stays with them is the clock's choice. So these
    // are ten runs, one after another.
    std::string relay;
    for (Index n = 0; n < steps; n += 7) {
      ExplicitRun run = explicit_run(model, options(threads));
      if (n > 0) run.load(relay);
      run.advance(7);
      relay = run.save();
    }
    EXPECT_TRUE(relay == expected);
  }
}

TEST_P(SameBits, AfterSavingAndLoadingAtAnyStep) {
  const Model model = large_packing(4);
  ExplicitRun straight = explicit_run(model, options(1));
  straight.set_velocity(40, vector6(1, 2, 3, 4, 5, 6));
  std::vector<std::string> saved;
  for (const Index more : {0, 1, 19, 40}) {
    straight.advance(more);
    saved.push_back(straight.save());
  }
  straight.advance(10);
  const std::string expected = straight.save();
  for (const std::string& from : saved) {
    ExplicitRun fresh = explicit_run(model, options(1));
    fresh.load(from);
    EXPECT_TRUE(fresh.save() == from);
    const Index left = straight.step() - fresh.step();
    for (Index n = 0; n < left; ++n) fresh.advance(1);
    EXPECT_TRUE(fresh.save() == expected) << "from step " << straight.step() - left;
    EXPECT_EQ(fresh.time(), straight.time());
    EXPECT_EQ(fresh.energies().work, straight.energies().work);
    EXPECT_EQ(fresh.state().displacement.back(), straight.state().displacement.back());
  }
}

TEST_P(SameBits, WithContactPointsBondByBondAsWithOneOfTheBlock) {
  Model of_block = large_packing(5), bond_by_bond = of_block;
  of_block.blocks[0].contact_point = {ContactPoint::Kind::fraction, 0.375};
  bond_by_bond.blocks[0].contact_point = {ContactPoint::Kind::gap};
  bond_by_bond.blocks[0].fractions.assign(of_block.bonds.size(), 0.375);
  ExplicitRun expected = explicit_run(of_block, options(1)), found = explicit_run(bond_by_bond, options(1));
  expected.advance(steps);
  found.advance(steps);
  EXPECT_TRUE(found.save() == expected.save());
}

INSTANTIATE_TEST_SUITE_P(Dynamics, SameBits,
                         ::testing::Values(Kind{Kinematics::small, false}, Kind{Kinematics::small, true},
                                           Kind{Kinematics::finite, false}, Kind{Kinematics::finite, true}));

std::string refusal(const Model& model, const DynamicOptions& options, const std::string& saved) {
  ExplicitRun run = explicit_run(model, options);
  try {
    run.load(saved);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    return error.what();
  }
  return "none";
}

TEST(SavedRun, OfAnotherModelIsRefused) {
  DynamicOptions options;
  options.time_step = 2e-5;
  const Model model = large_packing(3);
  ExplicitRun run = explicit_run(model, options);
  run.advance(3);
  const std::string saved = run.save();
  EXPECT_EQ(refusal(model, options, saved), "none");

  EXPECT_THAT(refusal(large_packing(4), options, saved), testing::HasSubstr("cure"));
  Model with_one_more = model;
  add_particle(with_one_more, Vector3(9, 9, 9), 0.5);
  with_one_more.particles.back().density = 1;
  EXPECT_THAT(refusal(with_one_more, options, saved), testing::HasSubstr("another model"));
  Model with_fewer_bonds = model;
  with_fewer_bonds.bonds.resize(model.bonds.size() - 8);
  EXPECT_THAT(refusal(with_fewer_bonds, options, saved), testing::HasSubstr("left over"));
  DynamicOptions small = options;
  small.kinematics = Kinematics::small;
  EXPECT_THAT(refusal(model, small, saved), testing::HasSubstr("another model"));
  DynamicOptions damped = options;
  damped.bond_damping.normal = 0.1;
  EXPECT_THAT(refusal(model, damped, saved), testing::HasSubstr("ends before"));
}

TEST(SavedRun, DamagedIsRefused) {
  DynamicOptions options;
  options.time_step = 2e-5;
  const Model model = large_packing(3);
  ExplicitRun run = explicit_run(model, options);
  run.advance(3);
  const std::string saved = run.save();
  EXPECT_THAT(refusal(model, options, saved.substr(0, saved.size() - 1)), testing::HasSubstr("damaged"));
  EXPECT_THAT(refusal(model, options, ""), testing::HasSubstr("is no explicit run"));
  for (std::size_t at = 0; at < saved.size(); at += 977) {
    std::string flipped = saved;
    flipped[at] = char(flipped[at] ^ 0x10);
    EXPECT_NE(refusal(model, options, flipped), "none") << at;
  }
}

}  // namespace
}  // namespace bondstatic::test
