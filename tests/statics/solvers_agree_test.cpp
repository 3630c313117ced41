// Every solver of the build gives the same displacements on thirty models: lattices, disordered packings,
// slender, thin and several bodies, stiffness over three decades, bonds without moments, particles 10:1.
#include <gtest/gtest.h>

#include "bondstatic/statics.hpp"
#include "multigrid/hard_models.hpp"

namespace bondstatic::test {
namespace {

HardModel milder(std::mt19937_64& random) {
  HardModel of = any_hard_model(random);
  of.decades = std::min(of.decades, 3.0);
  of.hinges = std::min(of.hinges, 0.5);
  for (Index& count : of.count) count = std::min<Index>(count, 24);
  return of;
}

class SolversAgree : public ::testing::TestWithParam<std::string> {};

TEST_P(SolversAgree, OnThirtyModels) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    std::mt19937_64 random(seed);
    const HardModel of = milder(random);
    const Model model = hard_model(random, of);
    StaticOptions options;
    options.threads = 1;
    const auto reference = solve_statics(model, [&] {
      StaticOptions direct = options;
      direct.solver = "eigen";
      return direct;
    }());
    options.solver = GetParam();
    const auto found = solve_statics(model, options);
    double apart = 0, size = 0;
    for (std::size_t p = 0; p < model.particles.size(); ++p) {
      const Vector6& u = reference.cases[0].displacement[p];
      apart = std::max(apart, (found.cases[0].displacement[p] - u).cwiseAbs().maxCoeff());
      size = std::max(size, u.cwiseAbs().maxCoeff());
    }
    EXPECT_LT(apart, 1e-14 * size) << "seed " << seed;
  }
}

std::vector<std::string> solvers() {
  std::vector<std::string> names;
  for (const SolverInfo& info : available_solvers())
    if (info.name != "eigen") names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Statics, SolversAgree, ::testing::ValuesIn(solvers()), [](const auto& chosen) {
  std::string name = chosen.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace bondstatic::test
