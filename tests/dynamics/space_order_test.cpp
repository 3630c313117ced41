// A large run keeps bodies and bonds along a curve through space; who looks at it sees the model's order.
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"
#include "dynamics/pair.hpp"
#include "support/shuffled.hpp"

namespace bondstatic::test {
namespace {

Model packing() {
  std::mt19937_64 random(7);
  Model model = random_packing(random, 26, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  std::uniform_real_distribution<double> density(2000, 3000);
  for (Particle& particle : model.particles) particle.density = density(random);
  for (Index p = 0; p < 26 * 26; ++p) fix_all(model, p);
  const Index last = Index(model.particles.size()) - 1;
  load(model, last, vector6(1e4, -2e4, 3e4, 1e3, 2e3, 3e3));
  fix_all(model, last - 40, vector6(1e-3, 0, -1e-3, 0, 1e-3, 0));
  return shuffled(model, random);
}

DynamicOptions options(Kinematics kinematics) {
  DynamicOptions result;
  result.kinematics = kinematics;
  result.particle_damping = 0.3;
  result.bond_damping = {.paper = 0.01, .normal = 0.02};
  result.time_step = 2e-5;
  result.threads = 3;
  return result;
}

class LargeRun : public ::testing::TestWithParam<Kinematics> {};

// Of a model that is in that order already, the run's order is the model's.
TEST_P(LargeRun, IsThatOfTheRenumberedModel) {
  const Model model = packing();
  ASSERT_TRUE(worth_renumbering(model));
  const SpaceOrder order = space_order(model);
  const Model near = renumbered(model, order);
  std::vector<bool> left_out(model.particles.size(), false), left_out_near = left_out;
  const Index alone = order.particle[3000];
  left_out[std::size_t(alone)] = left_out_near[3000] = true;
  const auto without = [](Model all, Index particle) {
    std::erase_if(all.bonds, [&](const Bond& bond) { return bond.a == particle || bond.b == particle; });
    return all;
  };
  const Model some = without(model, alone), some_near = without(near, 3000);

  ExplicitRun run(some, bond_properties(some), 0, left_out, options(GetParam()));
  ExplicitRun expected(some_near, bond_properties(some_near), 0, left_out_near, options(GetParam()));
  const Vector6 push = vector6(1, 2, 3, 4, 5, 6);
  run.set_velocity(order.particle[2000], push);
  expected.set_velocity(2000, push);
  run.advance(30);
  expected.advance(30);

  const State state = run.state(), wanted = expected.state();
  for (std::size_t i = 0; i < near.particles.size(); ++i) {
    const Index p = order.particle[i];
    ASSERT_EQ(run.velocity(p), expected.velocity(Index(i)));
    ASSERT_EQ(run.bond_force(p), expected.bond_force(Index(i)));
    ASSERT_EQ(run.orientation(p).coeffs(), expected.orientation(Index(i)).coeffs());
    if (p == alone) {
      EXPECT_TRUE(std::isnan(state.displacement[std::size_t(p)][0]));
      continue;
    }
    ASSERT_EQ(state.displacement[std::size_t(p)], wanted.displacement[i]);
    ASSERT_EQ(state.reaction[std::size_t(p)], wanted.reaction[i]);
  }
  const SpaceOrder of_bonds = space_order(some);
  for (std::size_t k = 0; k < some_near.bonds.size(); ++k) {
    const BondResult& bond = state.bonds[std::size_t(of_bonds.bond[k])];
    ASSERT_EQ(bond.force, wanted.bonds[k].force);
    ASSERT_EQ(bond.energy, wanted.bonds[k].energy);
  }
  EXPECT_EQ(run.unrest().particle, order.particle[std::size_t(expected.unrest().particle)]);
  EXPECT_EQ(run.unrest().fastest, expected.unrest().fastest);
  EXPECT_EQ(run.energies().work, expected.energies().work);
}

INSTANTIATE_TEST_SUITE_P(Dynamics, LargeRun, ::testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& of) { return of.param == Kinematics::small ? "small" : "finite"; });

TEST(LargeRun, NamesTheFirstOfTheModelsParticlesThatHasNoDensity) {
  Model model = packing();
  const SpaceOrder order = space_order(model);
  std::vector<Index> free;
  for (const Index p : {order.particle[9000], order.particle[100]})
    model.particles[std::size_t(p)].density = not_given, free.push_back(p);
  try {
    ExplicitRun run(model, bond_properties(model), 0, {}, options(Kinematics::small));
    FAIL();
  } catch (const Error& error) {
    const Index first = std::min(free[0], free[1]);
    EXPECT_NE(
        std::string(error.what())
            .find("particle " + std::to_string(model.particles[std::size_t(first)].id) + " has no density"),
        std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace bondstatic::test
