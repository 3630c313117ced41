// Cantilevers and frames against beam theory: [Chen2022] cases 1, 3 and 5, PFC's cantilever, a portal.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/statics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double pi = std::numbers::pi;

Vector6 tip_of(const Model& model) {
  return solve_statics(model, {}).cases[0].displacement.back();
}

Vector6 force_along(const Vector3& direction, double size) {
  Vector6 f = Vector6::Zero();
  f.head<3>() = size * direction;
  return f;
}

Vector6 moment_along(const Vector3& direction, double size) {
  Vector6 f = Vector6::Zero();
  f.tail<3>() = size * direction;
  return f;
}

// E = 1e10, nu = 0.25, r = 0.01, L = 1 along (0.6, 0.64, 0.48), in any number of bonds.
class SkewCantilever : public ::testing::TestWithParam<Index> {
 protected:
  const Vector3 axis{0.6, 0.64, 0.48}, across = Vector3(-0.64, 0.6, 0).normalized();

  Vector6 tip(const char* law, const Vector6& end_load) const {
    Model model = chain(block(law, {{"young", 1e10}, {"poisson", 0.25}, {"radius", 0.01}}), Vector3::Zero(),
                        axis, GetParam(), 0.01);
    load(model, GetParam(), end_load);
    return tip_of(model);
  }
};

TEST_P(SkewCantilever, EqualsTheClosedForms) {
  constexpr double tolerance = 1e-13;  // positions are rounded, everything else is exact
  EXPECT_NEAR(across.dot(tip("euler-bernoulli", force_along(across, 10)).head<3>()) / 0.04244131815783876, 1,
              tolerance);
  const Vector6 bent = tip("timoshenko", force_along(across, 10));
  EXPECT_NEAR(across.dot(bent.head<3>()) / 0.04245016009912164, 1, tolerance);
  EXPECT_NEAR(axis.cross(across).dot(bent.tail<3>()) / 0.06366197723675814, 1, tolerance);
  EXPECT_NEAR(axis.dot(tip("timoshenko", moment_along(axis, 1)).tail<3>()) / 0.015915494309189534, 1,
              tolerance);
  EXPECT_NEAR(axis.dot(tip("timoshenko", force_along(axis, 1000)).head<3>()) / 3.183098861837906e-4, 1,
              tolerance);
}

INSTANTIATE_TEST_SUITE_P(Verification, SkewCantilever, ::testing::Values(1, 2, 3, 7, 10, 64));

TEST(PfcCantilever, EqualsTheManualsClosedForms) {
  // 200 in long, radius 8 in, E = 1e4 ksi, G = 3759.4 ksi; unit end loads, Euler-Bernoulli.
  const double poisson = 1e4 / (2 * 3759.4) - 1;
  const auto tip = [poisson](const Vector6& end_load) {
    Model model = chain(block("euler-bernoulli", {{"young", 1e4}, {"poisson", poisson}, {"radius", 8}}),
                        Vector3::Zero(), Vector3(200, 0, 0), 10, 10);
    load(model, 10, end_load);
    return tip_of(model);
  };
  constexpr double tolerance = 1e-13;
  const Vector6 across = tip(vector6(0, 0, 1));
  EXPECT_NEAR(across[2] / 0.0828931995270288, 1, tolerance);
  EXPECT_NEAR(-across[4] / 6.216989964527162e-4, 1, tolerance);
  EXPECT_NEAR(tip(vector6(1, 0, 0))[0] / 9.94718394324346e-5, 1, tolerance);
  const Vector6 bent = tip(vector6(0, 0, 0, 0, 1, 0));
  EXPECT_NEAR(-bent[2] / 6.216989964527162e-4, 1, tolerance);
  EXPECT_NEAR(bent[4] / 6.216989964527162e-6, 1, tolerance);
  EXPECT_NEAR(tip(vector6(0, 0, 0, 1, 0, 0))[3] / 8.268593345383788e-6, 1, tolerance);
}

// [Chen2022] section 3: E = 200 GPa, nu = 0.3, r = 0.2 m, 4 m long, 100 kN across the tip.
struct PaperBeam {
  double length = 4, young = 200e9, poisson = 0.3, radius = 0.2, force = 100e3;
  double second_moment() const { return pi * std::pow(radius, 4) / 4; }
  double area() const { return pi * radius * radius; }
  double bending(double x) const { return force * x * x * (3 * length - x) / (6 * young * second_moment()); }
  double shear(double x) const { return 10 * force * x * 2 * (1 + poisson) / (9 * young * area()); }

  std::vector<Vector6> solve(const std::string& law, Index bonds, Values more = {}) const {
    Values values{{"young", young}, {"radius", radius}};
    if (more.empty()) more = {{"poisson", poisson}};
    values.insert(values.end(), more.begin(), more.end());
    Model model = chain(block(law, values), Vector3::Zero(), Vector3(length, 0, 0), bonds, 0.2);
    load(model, bonds, vector6(0, -force, 0));
    return solve_statics(model, {}).cases[0].displacement;
  }
};

TEST(ReferenceCantilever, EqualsThePrintedDigitsOfAllThreeModels) {
  const PaperBeam beam;
  const auto millimetres = [](const std::vector<Vector6>& u) { return -1e3 * u.back()[1]; };
  EXPECT_NEAR(millimetres(beam.solve("timoshenko", 10)), 8.534242, 5e-7);
  EXPECT_NEAR(millimetres(beam.solve("euler-bernoulli", 10)), 8.488264, 5e-7);
  EXPECT_NEAR(millimetres(beam.solve("parallel", 10)), 8.508423, 5e-7);
}

class AnyNumberOfBonds : public ::testing::TestWithParam<Index> {};

TEST_P(AnyNumberOfBonds, BeamBondsEqualTheirTheoryAtEveryParticle) {
  const PaperBeam beam;
  const Index n = GetParam();
  const auto timoshenko = beam.solve("timoshenko", n), euler = beam.solve("euler-bernoulli", n);
  for (Index i = 1; i <= n; ++i) {
    const double x = beam.length * double(i) / double(n);
    EXPECT_NEAR(-timoshenko[std::size_t(i)][1] / (beam.bending(x) + beam.shear(x)), 1, 1e-13);
    EXPECT_NEAR(-euler[std::size_t(i)][1] / beam.bending(x), 1, 1e-13);
  }
}

TEST_P(AnyNumberOfBonds, ParallelBondFollowsItsClosedForm) {
  const PaperBeam beam;
  const double n = double(GetParam()), l = beam.length;
  const double expected =
      beam.bending(l) * (1 - 1 / (4 * n * n)) + 0.9 * beam.shear(l);  // shear without 10/9
  EXPECT_NEAR(-beam.solve("parallel", GetParam()).back()[1] / expected, 1, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Verification, AnyNumberOfBonds, ::testing::Range(Index(1), Index(11)));

TEST(PaperCase3, RelativeErrorsOfTheParallelBond) {
  const PaperBeam beam;
  const double theory = beam.bending(4) + beam.shear(4);
  const std::pair<Index, double> percent[] = {{1, -24.92}, {2, -6.27},  {4, -1.61},
                                              {6, -0.745}, {8, -0.442}, {10, -0.303}};
  for (const auto& [n, expected] : percent)
    EXPECT_NEAR(100 * (-beam.solve("parallel", n).back()[1] / theory - 1), expected, n < 5 ? 5e-3 : 5e-4);
}

TEST(PaperCase5, ContactPointOfUnequalParticlesSpoilsTheParallelBond) {
  const PaperBeam beam;
  const double theory = beam.bending(4) + beam.shear(4);
  const auto percent = [&](const std::string& law, const Values& more, double middle) {
    Values values{{"young", beam.young}, {"radius", beam.radius}};
    values.insert(values.end(), more.begin(), more.end());
    Model model;
    model.blocks.push_back(block(law, values));
    add_particle(model, Vector3(0, 0, 0), 0.2);
    add_particle(model, Vector3(2, 0, 0), middle);
    add_particle(model, Vector3(4, 0, 0), 0.2);
    add_bond(model, 0, 1);
    add_bond(model, 1, 2);
    fix_all(model, 0);
    load(model, 2, vector6(0, -beam.force, 0));
    return 100 * (-tip_of(model)[1] / theory - 1);
  };
  const std::pair<double, double> parallel[] = {{0.2, -0.54}, {0.4, 3.38}, {0.8, 12.33}};
  for (const auto& [middle, expected] : parallel) {
    EXPECT_NEAR(percent("parallel", {{"kappa", 100.0 / 3}}, middle), expected, 5e-3);
    EXPECT_NEAR(percent("timoshenko", {{"poisson", 0.3}}, middle), 0, 1e-11);
    EXPECT_NEAR(percent("euler-bernoulli", {{"poisson", 0.3}}, middle), -0.539, 5e-4);
  }
}

// Fixed feet, columns of height h, beam of length l, horizontal force on one corner. An axially stiff portal
// sways by H h^3 (3q+2) / (12 E I (6q+1)), q = h/l for equal sections; a real one by 2.6 (r/h)^2 more at that
// corner.
TEST(Portal, SwaysAsFrameTheorySaysUpToAxialStretch) {
  const double e = 1e9, h = 1, l = 1, force = 1;
  const auto excess = [&](double r) {
    Model model;
    model.blocks.push_back(block("euler-bernoulli", {{"young", e}, {"poisson", 0.3}, {"radius", r}}));
    const Index n = 4;
    for (Index i = 0; i <= n; ++i) add_particle(model, Vector3(0, h * double(i) / double(n), 0), r);
    for (Index i = 1; i <= n; ++i) add_particle(model, Vector3(l * double(i) / double(n), h, 0), r);
    for (Index i = 1; i <= n; ++i) add_particle(model, Vector3(l, h - h * double(i) / double(n), 0), r);
    for (Index i = 0; i < 3 * n; ++i) add_bond(model, i, i + 1);
    fix_all(model, 0);
    fix_all(model, 3 * n);
    load(model, n, vector6(force, 0, 0));
    const double sway = solve_statics(model, {}).cases[0].displacement[std::size_t(n)][0];
    const double inextensible = 0.05952380952380952 * force * h * h * h / (e * pi * std::pow(r, 4) / 4);
    return (sway / inextensible - 1) / (r * r / (h * h));
  };
  EXPECT_NEAR(excess(1e-2), 2.6, 0.02);
  EXPECT_NEAR(excess(1e-3), excess(1e-2), 1e-2);  // of second order: the ratio settles
}

TEST(CantileverChain, RootBondCarriesTheLargestNormalStress) {
  const PaperBeam beam;
  Model model = chain(block("timoshenko", {{"young", beam.young}, {"poisson", 0.3}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(4, 0, 0), 10, 0.2);
  load(model, 10, vector6(0, -beam.force, 0));
  const auto result = solve_statics(model, {}).cases[0];
  const double lever = 4 - 0.2, polar = pi * std::pow(0.2, 4) / 2;  // moment at the middle of the root bond
  EXPECT_NEAR(result.bonds[0].sigma / (2 * beam.force * lever * 0.2 / polar), 1, 1e-13);
  for (std::size_t k = 1; k < result.bonds.size(); ++k) {
    EXPECT_LT(result.bonds[k].sigma, result.bonds[k - 1].sigma);
    EXPECT_NEAR(result.bonds[k].tau / (beam.force / beam.area()), 1, 1e-13);
  }
  EXPECT_NEAR(result.reaction[0][1] / beam.force, 1, 1e-15);
  EXPECT_NEAR(result.reaction[0][5] / (beam.force * 4), 1, 1e-15);
}

}  // namespace
}  // namespace bondstatic::test
