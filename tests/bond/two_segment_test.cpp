// The two-segment law against a stepped cantilever of two Timoshenko elements, and its contact point.
#include <Eigen/LU>

#include "bond/bond_fixture.hpp"
#include "bond/contact_point.hpp"

namespace bondstatic {
namespace {

const Inputs inputs{{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.6}};

/// 12x12 of a Timoshenko beam of the law's material along `branch`.
Matrix12 segment(const Vector3& branch, double radius) {
  return stiffness_matrix(link(evaluate("timoshenko", {{"young", 7e10}, {"poisson", 0.2}, {"radius", radius}},
                                        site(branch.norm(), 1, 1)),
                               branch));
}

/// Two beams end to end with the node between them condensed out.
Matrix12 stepped_beam(const Vector3& branch_a, double radius_a, const Vector3& branch_b, double radius_b) {
  const Matrix12 a = segment(branch_a, radius_a), b = segment(branch_b, radius_b);
  Matrix12 outer = Matrix12::Zero();
  outer.topLeftCorner<6, 6>() = a.topLeftCorner<6, 6>();
  outer.bottomRightCorner<6, 6>() = b.bottomRightCorner<6, 6>();
  Matrix6x12 to_middle;
  to_middle << a.bottomLeftCorner<6, 6>(), b.topRightCorner<6, 6>();
  const Matrix6 middle = a.bottomRightCorner<6, 6>() + b.topLeftCorner<6, 6>();
  return outer - to_middle.transpose() * middle.fullPivLu().solve(to_middle);
}

// The condensation subtracts matrices that are stiffer than the result: hence not 1e-14.
TEST(TwoSegmentLaw, IsTheSteppedBeamWithItsMiddleNodeCondensedOut) {
  RandomBonds random;
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    const double ra = random.uniform(0.05, 0.2), rb = random.uniform(0.05, 0.2);
    const double length = (ra + rb) * random.uniform(0.8, 3);
    const Vector3 axis = random.direction();
    const double a = length * ra / (ra + rb), b = length * rb / (ra + rb);
    const BondProperties p = evaluate("two-segment", inputs, site(length, ra, rb));
    const Matrix12 beam = stepped_beam(a * axis, 0.6 * ra, b * axis, 0.6 * rb);
    worst = std::max(worst, scaled_difference(stiffness_matrix(link(p, length * axis)), beam));
  }
  EXPECT_LT(worst, 5e-14);
}

TEST(TwoSegmentLaw, HasTheFlexibilityOfTwoCantilevers) {
  const double ra = 0.1, rb = 0.2, l = 0.6, e = 7e10, g = e / 2.4, pi = std::acos(-1.0);
  const double a = 0.2, b = 0.4, ia = pi / 4 * std::pow(0.06, 4), ib = pi / 4 * std::pow(0.12, 4);
  const double aa = pi * 0.06 * 0.06, ab = pi * 0.12 * 0.12;
  const SectionStiffness c = evaluate("two-segment", inputs, site(l, ra, rb)).stiffness;
  const double f11 =
      a * a * a / (3 * e * ia) + 10 * a / (9 * g * aa) + b * b * b / (3 * e * ib) + 10 * b / (9 * g * ab);
  const double f12 = a * a / (2 * e * ia) - b * b / (2 * e * ib), f22 = a / (e * ia) + b / (e * ib);
  // C (y, rz) times the flexibility is the unit matrix.
  EXPECT_NEAR(c.ks * f11 + c.coupling * f12, 1, 1e-14);
  EXPECT_NEAR(c.coupling * f12 + c.kb * f22, 1, 1e-14);
  EXPECT_NEAR(c.ks * f12 + c.coupling * f22, 0, 1e-14 * c.ks * std::abs(f12));
  EXPECT_NEAR(1 / c.kn, a / (e * aa) + b / (e * ab), 1e-14 / c.kn);
  EXPECT_NEAR(1 / c.kt, a / (2 * g * ia) + b / (2 * g * ib), 1e-14 / c.kt);
}

TEST(TwoSegmentLaw, IsTimoshenkosForEqualRadii) {
  RandomBonds random;
  for (int k = 0; k < 100; ++k) {
    const double radius = random.uniform(0.05, 0.2), length = radius * random.uniform(1.8, 5);
    const BondSite here = site(length, radius, radius);
    const BondProperties two = evaluate("two-segment", inputs, here);
    const BondProperties one =
        evaluate("timoshenko", {{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.6}}, here);
    EXPECT_EQ(two.fraction, 0.5);
    EXPECT_EQ(two.stiffness.coupling, 0);
    EXPECT_EQ(two.radius, one.radius);
    EXPECT_NEAR(two.stiffness.kn, one.stiffness.kn, 4e-15 * one.stiffness.kn);
    EXPECT_NEAR(two.stiffness.ks, one.stiffness.ks, 4e-15 * one.stiffness.ks);
    EXPECT_NEAR(two.stiffness.kt, one.stiffness.kt, 4e-15 * one.stiffness.kt);
    EXPECT_NEAR(two.stiffness.kb, one.stiffness.kb, 4e-15 * one.stiffness.kb);
  }
}

TEST(MovedStiffness, IsTheSameBondSeenFromAnotherPoint) {
  RandomBonds random;
  for (int k = 0; k < 100; ++k) {
    const BondSite here = random.gapped_site();
    const Vector3 branch = here.length * random.direction();
    const Link own = link(evaluate("two-segment", inputs, here), branch);
    Link elsewhere = own;
    elsewhere.fraction = random.uniform(-0.5, 1.5);
    elsewhere.stiffness = moved(own.stiffness, (elsewhere.fraction - own.fraction) * here.length);
    EXPECT_LT(scaled_difference(stiffness_matrix(elsewhere), stiffness_matrix(own)), 1e-14);
  }
}

/// A model of one two-segment bond along the x-axis.
Model one_bond(ContactPoint point) {
  Model model;
  model.particles = {{.id = 1, .position = {0, 0, 0}, .radius = 0.1},
                     {.id = 2, .position = {0.4, 0, 0}, .radius = 0.2}};
  model.blocks = {
      {.law = "two-segment", .parameters = {7e10, 0.2, 0.6}, .contact_point = point, .overrides = {}}};
  model.bonds = {{.id = 1, .a = 0, .b = 1, .branch = {0.4, 0, 0}}};
  return model;
}

TEST(TwoSegmentLaw, StaysTheSameBondAtAnyContactPoint) {
  const BondProperties own = bond_properties(one_bond({})).front();
  EXPECT_NEAR(own.fraction, 1.0 / 3, 1e-16);
  const Matrix12 expected = stiffness_matrix(link(own, {0.4, 0, 0}));
  for (const ContactPoint point :
       {ContactPoint{ContactPoint::Kind::gap, 0}, ContactPoint{ContactPoint::Kind::beam, 0},
        ContactPoint{ContactPoint::Kind::fraction, 0.9},
        ContactPoint{ContactPoint::Kind::section_change, 0}}) {
    const BondProperties there = bond_properties(one_bond(point)).front();
    EXPECT_LT(scaled_difference(stiffness_matrix(link(there, {0.4, 0, 0})), expected), 1e-14);
  }
  EXPECT_EQ(bond_properties(one_bond({ContactPoint::Kind::beam, 0})).front().fraction, 0.5);
}

}  // namespace
}  // namespace bondstatic
