// A periodic cell torn by its mean strain.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fracture/broken_model.hpp"
#include "support/periodic.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

constexpr double length = 0.5;

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

BondBlock beams() {
  return block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.15}});
}

SectionStiffness beam_stiffness() {
  return find_bond_law("timoshenko")
      ->evaluate({length, length / 2, length / 2, 1, 2}, beams().parameters)
      .stiffness;
}

/// Simple cubic of 3^3 (sites {0, 0, 0}), or with more sites in each cube of edge `edge`.
Model lattice(const std::vector<Vector3>& sites, double edge) {
  std::vector<Vector3> points;
  for (int n = 0; n < 27; ++n)
    for (const Vector3& site : sites) points.push_back(edge * (Vector3(n % 3, n / 3 % 3, n / 9) + site));
  Model model = periodic_model(points, std::vector<double>(points.size(), length / 2),
                               {{0, 0, 0}, 3 * edge * Matrix3::Identity()}, beams());
  model.blocks[0].strength =
      strength("contact-bond", {{"critical_tensile_force", 100}, {"critical_shear_force", 70}});
  return model;
}

TEST(FracturedCell, BreaksAtTheClosedFormStrain) {
  const SectionStiffness bond = beam_stiffness();
  struct Torn {
    std::vector<Vector3> sites;
    double edge;
    Index strain;          ///< of unit_strains(): zz, or xz as a tensor's component of a half
    double stretch, slip;  ///< of the bonds that break first, per length and unit
    std::size_t together;
    double modulus;  ///< stress conjugate to the largest component of the strain, per unit of it
  };
  const double fcc = std::sqrt(2.0) * length, s = std::sqrt(2.0) / length;
  const std::vector<Vector3> face{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  for (const Torn& torn : {Torn{{{0, 0, 0}}, length, 2, 1, 0, 27, bond.kn / length},
                           Torn{{{0, 0, 0}}, length, 4, 0, 0.5, 54, 2 * bond.ks / length},
                           Torn{face, fcc, 2, 0.5, 0.5, 27 * 16, s * (bond.kn + bond.ks)}}) {
    const Model model = lattice(torn.sites, torn.edge);
    FractureOptions options;
    options.pattern = torn.strain;
    const WatchedRun run = watched(model, options, one_thread());
    ASSERT_FALSE(run.found.events.empty());
    const FractureEvent& first = run.found.events[0];
    const double tension = bond.kn * length * torn.stretch / 100, shear = bond.ks * length * torn.slip / 70;
    EXPECT_NEAR(first.factor * std::max(tension, shear), 1, 1e-13);
    EXPECT_EQ(first.bonds.size(), torn.together);
    EXPECT_EQ(first.bonds[0].mode, tension > shear ? 0 : 1);
    const double volume = std::pow(3 * torn.edge, 3);
    EXPECT_NEAR(first.load / (torn.modulus * first.displacement * volume), 1, 1e-13);
    EXPECT_NEAR(first.load * first.displacement / (2 * run.states[0].energy), 1, 1e-13);
  }
}

TEST(FracturedCell, EveryStateEqualsAPlainSolveAndLoadAndDisplacementAreConjugate) {
  std::mt19937_64 random(9);
  Model model = periodic_packing(random, 4, beams());
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 1e6}});
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {3, 3};
  for (const Index strain : {2, 4}) {
    FractureOptions options;
    options.pattern = strain;
    const WatchedRun run = watched(model, options, one_thread());
    EXPECT_EQ(run.found.end, FractureEnd::separated) << run.found.reason;
    ASSERT_GT(run.states.size(), 20u);
    for (std::size_t e = 0; e < run.states.size(); e += 7) {
      const FractureEvent& event = run.found.events[e];
      EXPECT_NEAR(event.load * event.displacement / (2 * run.states[e].energy), 1, 1e-13) << e;
      const State fresh = solved_with_drop(broken_model(model, options, run.found, e, event.factor));
      EXPECT_LT(difference(run.states[e], fresh, run.found, e).largest(), 1e-14) << e;
    }
    EXPECT_LT(run.found.report.energy_balance, 1e-13);
  }
}

}  // namespace
}  // namespace bondstatic::test
