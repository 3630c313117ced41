// The lever arm of a criterion's own evaluation point, in a chain that is solved for.
#include <gtest/gtest.h>

#include "bondstatic/statics.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {
namespace {

TEST(Utilisation, OfACantileverChainIsThatOfItsLeverArms) {
  // Six bonds of 0.5 along (0.6, 0.64, 0.48), unequal radii, load of 10 across the tip.
  const Vector3 axis(0.6, 0.64, 0.48), across = Vector3(0.8, -0.48, -0.36);
  Model model;
  model.blocks.push_back({.law = "parallel",
                          .parameters = {1e9, 0.2, not_given, 0.05, not_given},
                          .contact_point = {},
                          .overrides = {}});
  for (Index k = 0; k <= 6; ++k) {
    model.particles.push_back({k + 1, 0.5 * double(k) * axis, k % 2 ? 0.1 : 0.2});
    if (k > 0) model.bonds.push_back({k, k - 1, k, 0.5 * axis, 0, k - 1});
  }
  model.supports.push_back({0, {true, true, true, true, true, true}});
  Vector6 load = Vector6::Zero();
  load.head<3>() = 10 * across;
  model.loads.push_back({6, load});
  const StaticSolution solution = solve_statics(model, {});
  const std::vector<BondProperties> properties = bond_properties(model);
  for (Index k = 0; k < 6; ++k) {
    const double fraction = properties[std::size_t(k)].fraction, left = 0.5 * double(6 - k);
    const Vector6 q = -solution.cases[0].bonds[std::size_t(k)].force;
    const SectionVector v = section_vector(model.bonds[std::size_t(k)].branch, q);
    for (const double at : {0.0, fraction, 0.5, 1.0}) {
      const std::vector<FailureMode> modes{{.name = 0, .bending = 1, .at = at}};
      EXPECT_NEAR(utilisation(modes, 0.5, fraction, v).value, 10 * (left - 0.5 * at), 1e-12 * 30);
    }
  }
}

}  // namespace
}  // namespace bondstatic
