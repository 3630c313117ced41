// Long chains lose digits as the cube of their length in an assembled matrix; the natural form must not.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/statics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double young = 1e10, poisson = 0.25, bond_radius = 0.01;
constexpr long double pi = std::numbers::pi_v<long double>;

long double second_moment(long double r) {
  return pi * r * r * r * r / 4;
}
long double area(long double r) {
  return pi * r * r;
}

// [Chen2022] Eq. 28 for unit load at the tip.
long double timoshenko_deflection(long double x, long double length) {
  const long double shear_modulus = young / (2 * (1 + static_cast<long double>(poisson)));
  return x * x * (3 * length - x) / (6 * young * second_moment(bond_radius)) +
         10 * x / (9 * shear_modulus * area(bond_radius));
}

class LongChain : public ::testing::TestWithParam<Index> {};

TEST_P(LongChain, EqualsBeamTheoryAlongASkewAxis) {
  const Index bonds = GetParam();
  const Vector3 axis(0.6, 0.64, 0.48), across = Vector3(-0.64, 0.6, 0).normalized();
  Model model = chain(block("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", bond_radius}}),
                      Vector3::Zero(), axis, bonds, 0.5 / double(bonds));
  Vector6 force = Vector6::Zero();
  force.head<3>() = 10 * across;
  load(model, bonds, force);
  const auto solution = solve_statics(model, {});
  const LoadCaseResult& result = solution.cases[0];

  const long double length = model.particles.back().position.cast<long double>().norm();
  // Relative to the displacement at the particle itself, from the tenth part of the length on; nearer to the
  // support the direction of the axis, rounded in the positions, weighs more than the displacement.
  for (std::size_t p = model.particles.size() / 10 + 1; p < model.particles.size(); ++p) {
    const long double x = model.particles[p].position.cast<long double>().norm();
    const long double expected = 10 * timoshenko_deflection(x, length);
    const long double found =
        across.cast<long double>().dot(result.displacement[p].head<3>().cast<long double>());
    ASSERT_NEAR(double(found / expected), 1, 1e-13) << "particle " << p;
  }
  for (const BondResult& bond : result.bonds) ASSERT_NEAR(bond.shear_force / 10, 1, 1e-15);
  EXPECT_LT(result.accuracy.backward_error, 1e-15);
  EXPECT_LT(result.accuracy.forward_error, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Verification, LongChain, ::testing::Values(10, 100, 1000, 10000),
                         [](const auto& chosen) { return std::to_string(chosen.param) + "Bonds"; });

// Soft near the support and stiff beyond, or the other way round: compliances add.
class SeriesContrast : public ::testing::TestWithParam<bool> {};

TEST_P(SeriesContrast, EqualsTheSumOfCompliances) {
  const bool soft_first = GetParam();
  const double soft = 1e3, stiff = 1e11, nu = 0.3, r = 0.05;
  const Index half = 10;
  const double pitch = 0.125;  // positions are exact
  Model model;
  for (const double modulus : {soft, stiff})
    model.blocks.push_back(block("timoshenko", {{"young", modulus}, {"poisson", nu}, {"radius", r}}));
  for (Index i = 0; i <= 2 * half; ++i) add_particle(model, Vector3(pitch * double(i), 0, 0), r);
  for (Index i = 0; i < 2 * half; ++i) add_bond(model, i, i + 1, (i < half) == soft_first ? 0 : 1);
  fix_all(model, 0);
  load(model, 2 * half, vector6(3, 2, 0, 0.5, 0, 0));
  const auto result = solve_statics(model, {}).cases[0];

  const long double l = static_cast<long double>(pitch) * half, nu_l = nu;
  const auto segment = [&](long double e) {
    struct {
      long double ea, ei, ga, gj;
    } s{e * area(r), e * second_moment(r), e / (2 * (1 + nu_l)) * area(r) * 9 / 10,
        e / (2 * (1 + nu_l)) * 2 * second_moment(r)};
    return s;
  };
  const auto root = segment(soft_first ? soft : stiff), end = segment(soft_first ? stiff : soft);
  // Root segment under force P and moment P l at its end, end segment as a cantilever on it.
  const long double p = 2;
  const long double slope = p * l * l / (2 * root.ei) + p * l * l / root.ei;
  const long double middle = p * l * l * l / (3 * root.ei) + p * l * l * l / (2 * root.ei) + p * l / root.ga;
  const long double tip = middle + slope * l + p * l * l * l / (3 * end.ei) + p * l / end.ga;
  const Vector6& u = result.displacement.back();
  EXPECT_NEAR(double(u[0] / (3 * l / root.ea + 3 * l / end.ea)), 1, 1e-13);
  EXPECT_NEAR(double(u[1] / tip), 1, 1e-13);
  EXPECT_NEAR(double(u[3] / (0.5L * l / root.gj + 0.5L * l / end.gj)), 1, 1e-13);
  EXPECT_NEAR(double(u[5] / (slope + p * l * l / (2 * end.ei))), 1, 1e-13);
  EXPECT_NEAR(double(result.displacement[std::size_t(half)][1] / middle), 1, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Verification, SeriesContrast, ::testing::Bool(),
                         [](const auto& chosen) { return chosen.param ? "SoftFirst" : "StiffFirst"; });

}  // namespace
}  // namespace bondstatic::test
