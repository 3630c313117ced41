// The concave-end integrals against a closed form (equal radii) and graded Gauss quadrature (unequal radii).
#include <array>
#include <numbers>

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

struct Integrals {
  Real first = 0;  ///< of rho / l
  Real third = 0;  ///< of rho^3 / l
};

/// Equal radii: with s = sqrt(R^2 - rho^2) and v = l = g + 2R - 2s both integrands are polynomials over v.
Integrals closed_form(Real gap, Real big, Real r) {
  const Real length = gap + 2 * big, s = std::sqrt((big - r) * (big + r));
  const Real v = length - 2 * s, log = std::log(v / gap), cap = r * r / (big + s);
  const Real first = -cap / 2 + length / 4 * log;
  const Real cubic = (length * length * length * log - 3 * length * length * (v - gap) +
                      1.5L * length * (v - gap) * (v + gap) - (v * v * v - gap * gap * gap) / 3) /
                     16;
  return {first, big * big * first - cubic};
}

constexpr int order = 20;

/// Nodes and weights on [-1, 1] by Newton's method on the Legendre polynomial.
std::array<std::array<Real, 2>, order> gauss() {
  std::array<std::array<Real, 2>, order> rule;
  for (int k = 0; k < order; ++k) {
    Real x = std::cos(pi * (k + 0.75L) / (order + 0.5L)), slope = 1;
    for (int step = 0; step < 100; ++step) {
      Real p = 1, before = 0;
      for (int n = 0; n < order; ++n) {
        const Real next = ((2 * n + 1) * x * p - n * before) / (n + 1);
        before = p;
        p = next;
      }
      slope = order * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule[std::size_t(k)] = {x, 2 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

/// rho = r sin(phi) takes the square root's end out where r = R. Panels halve towards the peak at phi = 0 and
/// towards phi = pi/2, where the root of the larger sphere ends almost at r if the radii are nearly equal.
Integrals by_gauss(Real gap, Real ra, Real rb, Real r) {
  static const auto rule = gauss();
  const auto cap = [](Real big, Real rho, Real rest) { return rho * rho / (big + std::sqrt(rest)); };
  Integrals sum;
  const auto add = [&](Real sine, Real cosine, Real weight) {
    const Real rho = r * sine, c = r * cosine;
    const Real l =
        gap + cap(ra, rho, (ra - r) * (ra + r) + c * c) + cap(rb, rho, (rb - r) * (rb + r) + c * c);
    sum.first += weight * c * rho / l;
    sum.third += weight * c * rho * rho * rho / l;
  };
  Real high = pi / 4;
  for (int panel = 0; panel <= 60; ++panel) {
    const Real low = panel < 60 ? high / 2 : 0;
    for (const auto& [x, weight] : rule) {
      const Real distance = (low + high) / 2 + (high - low) / 2 * x, w = weight * (high - low) / 2;
      add(std::sin(distance), std::cos(distance), w);
      add(std::cos(distance), std::sin(distance), w);
    }
    high = low;
  }
  return sum;
}

const double e = 5e10, nu = 0.2;

void expect_integrals(const BondSite& here, double r, const Integrals& expected) {
  const SectionStiffness c =
      evaluate("concave-end", {{"young", e}, {"poisson", nu}, {"radius", r}}, here).stiffness;
  const Real g = e / (2 * (1 + Real(nu)));
  const auto near = [&](double found, Real value) { EXPECT_NEAR(double(found / value - 1), 0, 2e-15); };
  near(c.kn, 2 * pi * e * expected.first);
  near(c.ks, 2 * pi * g * expected.first);
  near(c.kt, 2 * pi * g * expected.third);
  near(c.kb, pi * e * expected.third);
}

TEST(ConcaveEndLaw, EqualsTheClosedFormForEqualRadii) {
  for (const double big : {0.3, 1.0})
    for (const double gap : {1.0, 1e-2, 1e-4, 1e-8})
      for (const double ratio : {0.2, 0.8, 1.0}) {
        const BondSite here = site(2 * big + gap * big, big, big);
        SCOPED_TRACE(testing::Message() << "R " << big << " gap/R " << gap << " r/R " << ratio);
        expect_integrals(here, ratio * big, closed_form(here.gap(), big, ratio * big));
      }
}

TEST(ConcaveEndLaw, EqualsGaussQuadratureForUnequalRadii) {
  for (const double larger : {0.3001, 0.5, 3.0})
    for (const double gap : {1.0, 1e-2, 1e-4, 1e-8, 1e-12})
      for (const double ratio : {0.01, 0.8, 1 - 1e-9, 1.0}) {
        const BondSite here = site(larger + 0.3 + gap * 0.3, larger, 0.3);
        SCOPED_TRACE(testing::Message() << "R " << larger << " gap/R " << gap << " r/R " << ratio);
        expect_integrals(here, ratio * 0.3, by_gauss(here.gap(), larger, 0.3, ratio * 0.3));
      }
}

TEST(ConcaveEndLaw, TendsToAStraightCylinderForAThinBond) {
  // r << R: every fibre is as long as the gap.
  const double r = 1e-6, gap = 0.5;
  const SectionStiffness c =
      evaluate("concave-end", {{"young", e}, {"poisson", nu}, {"radius", r}}, site(2 + gap, 1, 1)).stiffness;
  const double kn = double(pi) * e * r * r / gap;
  EXPECT_NEAR(c.kn / kn, 1, 1e-11);
  EXPECT_NEAR(c.kb / (0.25 * kn * r * r), 1, 1e-11);
}

TEST(ConcaveEndLaw, NeedsAGapAndABondInsideTheSpheres) {
  const BondLaw& law = *find_bond_law("concave-end");
  const auto forbids = [&](double length, double r) {
    return law.forbids(site(length, 1, 0.5), std::vector<double>{e, nu, r, not_given});
  };
  EXPECT_EQ(forbids(1.6, 0.5), "");
  EXPECT_THAT(forbids(1.5, 0.5), testing::StartsWith("gap = 0 must be positive; "));
  EXPECT_THAT(forbids(1.25, 0.5), testing::StartsWith("gap = -0.25 must be positive; "));
  EXPECT_THAT(forbids(1.6, 0.75),
              testing::StartsWith("bond radius 0.75 must not exceed the smaller particle radius 0.5; "));
}

}  // namespace
}  // namespace bondstatic
