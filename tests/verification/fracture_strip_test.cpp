// Double cantilever strip: two chains of beam bonds joined by cross bonds over the uncracked part, opened by
// P on the ends of both. Dead loads, a = distance from the loads to the last cross bond that holds (before it
// breaks). By symmetry each arm is a cantilever of length a on the compliant root of the uncracked part, and
//
//     opening / P = 2 (a^3 / 3EI + 2 r_vm a + r_mm a^2 + r_vv)
//
// with r the deflection and rotation of the root's last node under unit force and unit moment. A break of
// pitch p releases P^2 / 2 times what that grows by from a to a + p:
//
//     P^2 p (a^2 + a p + p^2 / 3) / EI  +  P^2 p (r_mm (2 a + p) + 2 r_vm),
//
// the first being the textbook's, the second of order 1 / a beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bondstatic/fracture.hpp"
#include "bondstatic/statics.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

constexpr double pitch = 0.5, young = 1e9, radius = pitch / 2;
constexpr double inertia = std::numbers::pi * radius * radius * radius * radius / 4;
constexpr Index root = 80;                     // cross bonds left in the end: the far end, held, is not felt
constexpr Index shortest = 20, longest = 160;  // cracks, in pitches

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// Nodes of the lower chain first. `bonded` cross bonds from the held end on, `beyond` pitches of arms
/// without.
Model strip(Index bonded, Index beyond) {
  Model model;
  for (const double r : {radius, radius / 4})  // slender cross bonds: a root that yields
    model.blocks.push_back(block("euler-bernoulli", {{"young", young}, {"poisson", 0.2}, {"radius", r}}));
  const Index nodes = bonded + beyond;
  for (const double y : {0.0, pitch})
    for (Index i = 0; i < nodes; ++i) add_particle(model, Vector3(double(i) * pitch, y, 0), radius);
  for (const Index first : {Index(0), nodes})
    for (Index i = 0; i + 1 < nodes; ++i) add_bond(model, first + i, first + i + 1);
  for (Index i = 0; i < bonded; ++i) add_bond(model, i, nodes + i, 1);
  fix_all(model, 0);
  fix_all(model, nodes);
  return model;
}

/// Half the opening and the rotation of the last node under P = 1 and M = 1 on each arm (columns).
Eigen::Matrix2d root_compliance() {
  Model model = strip(root, 0);
  model.load_cases = {"force", "moment"};
  load(model, root - 1, vector6(0, -1, 0), 0);
  load(model, 2 * root - 1, vector6(0, 1, 0), 0);
  load(model, root - 1, vector6(0, 0, 0, 0, 0, -1), 1);
  load(model, 2 * root - 1, vector6(0, 0, 0, 0, 0, 1), 1);
  const StaticSolution solved = solve_statics(model, one_thread());
  Eigen::Matrix2d compliance;
  for (int c = 0; c < 2; ++c) {
    const Vector6& end = solved.cases[std::size_t(c)].displacement[std::size_t(2 * root - 1)];
    compliance.col(c) << end[1], end[5];
  }
  EXPECT_NEAR(compliance(0, 1) / compliance(1, 0), 1, 1e-12);
  return compliance;
}

TEST(DoubleCantileverStrip, ReleasesTheTextbooksEnergyWithinTheRootsRotation) {
  const Index cracks = longest - shortest + 1, bonded = root + cracks, nodes = bonded + shortest;
  // The last cross bond is `shortest` pitches from the loads, which are on the last nodes.
  Model model = strip(bonded, shortest);
  model.blocks[1].strength =
      strength("contact-bond", {{"critical_tensile_force", 1}, {"critical_shear_force", 1e9}});
  load(model, nodes - 1, vector6(0, -1, 0));
  load(model, 2 * nodes - 1, vector6(0, 1, 0));
  FractureOptions options;  // control by events: released at the constant load that breaks the bond
  options.max_breaks = cracks;
  const Fracture found = fracture(model, options, one_thread());
  ASSERT_EQ(found.end, FractureEnd::breaks);
  ASSERT_EQ(found.events.size(), std::size_t(cracks));
  const Eigen::Matrix2d compliance = root_compliance();
  std::vector<double> error;
  for (std::size_t e = 0; e < found.events.size(); ++e) {
    const FractureEvent& event = found.events[e];
    const double a = double(shortest + Index(e)) * pitch, p = pitch, force = event.factor;
    ASSERT_EQ(event.bonds.size(), 1u);
    ASSERT_EQ(event.bonds[0].bond, Index(model.bonds.size() - e) - 1);  // the crack runs from its tip
    EXPECT_NEAR(event.load / (2 * force), 1, 1e-15);
    const double textbook = force * force * p * (a * a + a * p + p * p / 3) / (young * inertia);
    const double of_root = force * force * p * (compliance(1, 1) * (2 * a + p) + 2 * compliance(0, 1));
    EXPECT_NEAR(event.released / (textbook + of_root), 1, 1e-11) << "a = " << a / p << " p";
    error.push_back(event.released / textbook - 1);
    // Of first order in 1 / a: error times a changes by what is of second order.
    EXPECT_NEAR(error.back() * a / (error[0] * shortest * p), 1, 0.05) << "a = " << a / p << " p";
  }
  EXPECT_NEAR(error.front(), 0.08, 0.003);
  EXPECT_NEAR(error.back(), 0.01, 0.0005);
  EXPECT_LT(found.report.energy_balance, 1e-11);
}

}  // namespace
}  // namespace bondstatic::test
