// One bond in each of its six relative motions against [Chen2022] Table 2, 7 and 8 worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/pair.hpp"

namespace bondstatic::test {
namespace {

constexpr double kn = 5e4, ks = 2e4, kt = 700, kb = 1100;
constexpr double length = 1.25, radius_a = 0.3, radius_b = 0.5;

/// What the bond does to the centres of a and b, in its axes.
struct Ends {
  Vector6 a, b;
};

/// Right column of Table 8 from force and moment at the contact point, r_ac = a and r_bc = b apart from the
/// centres.
Ends table_8(const Vector3& f, const Vector3& m, double a, double b) {
  return {vector6(-f[0], -f[1], -f[2], -m[0], -m[1] + a * f[2], -m[2] - a * f[1]),
          vector6(f[0], f[1], f[2], m[0], m[1] + b * f[2], m[2] - b * f[1])};
}

struct Place {
  const char* name;
  ContactPoint point;
  double a;      ///< by hand
  double share;  ///< of a stretch that falls on a's side
};

// gap: (1.25 + 0.3 - 0.5) / 2; contact radii 1.5 times the real ones: (1.25 + 0.45 - 0.75) / 2.
const Place places[] = {{"gap", {ContactPoint::Kind::gap, 0}, 0.525, 0.5},
                        {"beam", {ContactPoint::Kind::beam, 0}, 0.625, 0.5},
                        {"fraction", {ContactPoint::Kind::fraction, 0.2}, 0.25, 0.2},
                        {"contact radii", {ContactPoint::Kind::contact_radii, 1.5}, 0.475, 0.5}};

Values stiffness() {
  return {{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}};
}

struct Moved {
  Index particle = 1;
  Vector6 by = Vector6::Zero();  ///< in the bond's axes
};

DynamicOptions in_steps(Kinematics kinematics, Index steps) {
  DynamicOptions options;
  options.kinematics = kinematics;
  options.particle_damping = 0;
  options.time_step = 1.0 / 1024;
  options.ramp_time = double(steps) * options.time_step;
  return options;
}

/// Both particles held, one of them moved along a linear ramp.
struct Result {
  Ends ends;
  State state;
};
Result pushed(const BondBlock& bond, const Moved& moved, Kinematics kinematics, Index steps = 512,
              double radius_of_b = radius_b) {
  const Matrix3 axes = skew_axes();
  Model model = pair(bond, axes, length, radius_a, radius_of_b);
  fix_all(model, moved.particle, turned(axes, moved.by));
  fix_all(model, 1 - moved.particle);
  ExplicitRun run = explicit_run(model, in_steps(kinematics, steps));
  run.advance(steps);
  const Matrix3 back = axes.transpose();
  return {{turned(back, run.bond_force(0)), turned(back, run.bond_force(1))}, run.state()};
}

void expect_ends(const Result& found, const Ends& expected, double tolerance) {
  const double scale = expected.a.norm() + expected.b.norm();
  EXPECT_LE((found.ends.a - expected.a).norm(), tolerance * scale) << found.ends.a.transpose();
  EXPECT_LE((found.ends.b - expected.b).norm(), tolerance * scale) << found.ends.b.transpose();
  const Matrix3 back = skew_axes().transpose();
  EXPECT_LE((turned(back, found.state.reaction[0]) + expected.a).norm(), tolerance * scale);
  EXPECT_LE((turned(back, found.state.reaction[1]) + expected.b).norm(), tolerance * scale);
}

struct Motion {
  const char* name;
  Moved moved;
  Vector3 force, moment;  ///< F_c and M_c
};

/// All six, of b and then of a. Frames do not turn in any but shear, so that kinematics make no difference.
std::vector<Motion> motions(double a, double d, double turn) {
  const double b = length - a;
  const Vector3 none = Vector3::Zero();
  return {
      {"stretched by b", {1, vector6(d, 0, 0)}, {-kn * d, 0, 0}, none},
      {"sheared along y by b", {1, vector6(0, d, 0)}, {0, -ks * d, 0}, none},
      {"sheared along z by b", {1, vector6(0, 0, d)}, {0, 0, -ks * d}, none},
      {"twisted by b", {1, vector6(0, 0, 0, turn, 0, 0)}, none, {-kt * turn, 0, 0}},
      {"bent about y by b", {1, vector6(0, 0, 0, 0, turn, 0)}, {0, 0, -ks * b * turn}, {0, -kb * turn, 0}},
      {"bent about z by b", {1, vector6(0, 0, 0, 0, 0, turn)}, {0, ks * b * turn, 0}, {0, 0, -kb * turn}},
      {"compressed by a", {0, vector6(d, 0, 0)}, {kn * d, 0, 0}, none},
      {"sheared along y by a", {0, vector6(0, d, 0)}, {0, ks * d, 0}, none},
      {"sheared along z by a", {0, vector6(0, 0, d)}, {0, 0, ks * d}, none},
      {"twisted by a", {0, vector6(0, 0, 0, turn, 0, 0)}, none, {kt * turn, 0, 0}},
      {"bent about y by a", {0, vector6(0, 0, 0, 0, turn, 0)}, {0, 0, -ks * a * turn}, {0, kb * turn, 0}},
      {"bent about z by a", {0, vector6(0, 0, 0, 0, 0, turn)}, {0, ks * a * turn, 0}, {0, 0, kb * turn}}};
}

constexpr double rounding = 1e-13;  // of 512 increments

/// What the spins of a moved support add up to where kinematics are finite: a step's Cayley rotation by
/// tan(half of its angle) is what ends at the angle, and the bond's increments are those of the spin.
double spun(double angle, Index steps = 512) {
  return 2 * double(steps) * std::tan(angle / double(2 * steps));
}

TEST(TwoParticles, ForcesAndMomentsAtBothCentresAreThoseOfTable8) {
  for (const Place& place : places)
    for (const Motion& motion : motions(place.a, 1e-3, 2e-3)) {
      SCOPED_TRACE(std::string(place.name) + ", " + motion.name);
      const Result found =
          pushed(block("generic", stiffness(), place.point), motion.moved, Kinematics::small);
      expect_ends(found, table_8(motion.force, motion.moment, place.a, length - place.a), rounding);
    }
}

TEST(TwoParticles, LargeMotionsWithoutShearGiveTheSameInBothKinematics) {
  for (const Place& place : places)
    for (const Motion& motion : motions(place.a, 0.3, spun(0.8))) {
      if (std::string(motion.name).find("sheared") == 0) continue;
      SCOPED_TRACE(std::string(place.name) + ", " + motion.name);
      Moved moved = motion.moved;
      moved.by.tail<3>() *= 0.8 / spun(0.8);
      const Result found = pushed(block("generic", stiffness(), place.point), moved, Kinematics::finite);
      expect_ends(found, table_8(motion.force, motion.moment, place.a, length - place.a), rounding);
    }
}

// With b going across, F_x = -kn (l - L) and dF_y = -ks dy cos(phi) where tan(phi) = y / L: the bond turns by
// phi and carries ks L asinh(y / L).
TEST(TwoParticles, LargeShearTurnsTheBondAndConvergesWithTheSquareOfTheStep) {
  const double d = 0.5, turned_length = std::hypot(length, d), phi = std::atan2(d, length);
  for (const Place& place : places) {
    SCOPED_TRACE(place.name);
    const double a = place.a + place.share * (turned_length - length);
    const Vector3 force(-kn * (turned_length - length), -ks * length * std::asinh(d / length), 0);
    const Ends in_bond = table_8(force, Vector3::Zero(), a, turned_length - a);
    const Matrix3 turn = Eigen::AngleAxisd(phi, Vector3::UnitZ()).toRotationMatrix();
    const Ends expected{turned(turn, in_bond.a), turned(turn, in_bond.b)};
    const auto found = [&](Index steps) {
      return pushed(block("generic", stiffness(), place.point), {1, vector6(0, d, 0)}, Kinematics::finite,
                    steps);
    };
    const auto error = [&](Index steps) {
      return (found(steps).ends.b - expected.b).norm() / expected.b.norm();
    };
    EXPECT_NEAR(error(100) / error(200), 4, 1e-2);
    expect_ends(found(20000), expected, 1e-9);
  }
}

// Stretched and bent at once by b: the lever arm grows with the stretch, so that F_y = ks turn (b + half of
// its growth).
TEST(TwoParticles, ContactPointFollowsAStretchByItsShare) {
  const double d = 0.3, turn = spun(0.8);
  for (const Place& place : places) {
    SCOPED_TRACE(place.name);
    const double b = length - place.a, growth = (1 - place.share) * d;
    const Vector3 force(-kn * d, ks * turn * (b + growth / 2), 0), moment(0, 0, -kb * turn);
    const Result found = pushed(block("generic", stiffness(), place.point), {1, vector6(d, 0, 0, 0, 0, 0.8)},
                                Kinematics::finite);
    expect_ends(found, table_8(force, moment, place.a + place.share * d, b + growth), rounding);
  }
}

/// F_c or M_c of increments of size one along y, spread evenly over a turn of the bond by `angle` about its
/// axis, which carries each of them from then on.
Vector3 carried(double angle) {
  return {0, std::sin(angle) / angle, (1 - std::cos(angle)) / angle};
}

// Both particles turn about the bond's axis by a large angle, and b by a tiny one about y fixed in space.
TEST(TwoParticles, ForceAndMomentTurnWithTheBond) {
  const double angle = 2, bend = 1e-6;
  const Index steps = 4096;
  for (const Place& place : places) {
    SCOPED_TRACE(place.name);
    const Matrix3 axes = skew_axes();
    Model model = pair(block("generic", stiffness(), place.point), axes, length, radius_a, radius_b);
    fix_all(model, 0, turned(axes, vector6(0, 0, 0, angle, 0, 0)));
    fix_all(model, 1, turned(axes, vector6(0, 0, 0, angle, bend, 0)));
    ExplicitRun run = explicit_run(model, in_steps(Kinematics::finite, steps));
    run.advance(steps);
    const Matrix3 back = axes.transpose();
    const Result found{{turned(back, run.bond_force(0)), turned(back, run.bond_force(1))}, run.state()};
    const Vector3 y = carried(angle), z = Vector3::UnitX().cross(y);
    const double b = length - place.a;
    // Of second order in the step, and in the bend.
    expect_ends(found, table_8(-ks * b * bend * z, -kb * bend * y, place.a, b), 1e-6);
    const Matrix3 turn = Eigen::AngleAxisd(angle, axes.col(0)).toRotationMatrix();
    EXPECT_LT((run.orientation(0).toRotationMatrix() - turn).norm(), 1e-12);
  }
}

TEST(TwoParticles, BondResultsAreThoseAtTheContactPoint) {
  const double d = 1e-3, turn = 2e-3, a = 0.525, b = length - a;
  const Result found = pushed(block("generic", stiffness(), places[0].point),
                              {1, vector6(d, 2 * d, -d, turn, 3 * turn, -turn)}, Kinematics::small);
  const BondResult& bond = found.state.bonds[0];
  const Vector3 force(-kn * d, -ks * (2 * d + b * turn), -ks * (-d + 3 * b * turn));
  const Vector3 moment(-kt * turn, -3 * kb * turn, kb * turn);
  EXPECT_NEAR(bond.normal_force, kn * d, rounding * kn * d);
  EXPECT_NEAR(bond.shear_force, std::hypot(force[1], force[2]), rounding * kn * d);
  EXPECT_NEAR(bond.twisting_moment, -kt * turn, rounding * kn * d);
  EXPECT_NEAR(bond.bending_moment, kb * turn * std::sqrt(10.0), rounding * kn * d);
  Vector6 expected;
  expected << force, moment;
  EXPECT_LE((turned(skew_axes().transpose(), bond.force) - expected).norm(), rounding * expected.norm());
  const double energy = kn * d * d / 2 + force.tail<2>().squaredNorm() / (2 * ks) + kt * turn * turn / 2 +
                        10 * kb * turn * turn / 2;
  EXPECT_NEAR(bond.energy / energy, 1, rounding);
  EXPECT_NEAR(found.state.energy / energy, 1, rounding);
  EXPECT_NEAR(found.state.work / energy, 1, rounding);  // forces grow in proportion to the motion
}

TEST(TwoParticles, WithoutTorqueFeedbackMomentsStayInTheBond) {
  const double radius = 0.3, area = std::numbers::pi * radius * radius, polar = area * radius * radius / 2;
  const double normal = 3e5, shear = 1e5, angle = 2e-3, a = 0.525, b = length - a;
  const BondBlock bond =
      block("edem-v2", {{"normal_stiffness", normal}, {"shear_stiffness", shear}, {"torque_feedback", 0}});
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    const double turn = kinematics == Kinematics::finite ? spun(angle) : angle, scale = normal * area * turn;
    const Result twisted = pushed(bond, {1, vector6(0, 0, 0, angle, 0, 0)}, kinematics);
    EXPECT_LE(twisted.ends.a.norm() + twisted.ends.b.norm(), 1e-15 * scale);
    EXPECT_NEAR(twisted.state.bonds[0].twisting_moment / (-shear * polar * turn), 1, rounding);
    EXPECT_LE(twisted.state.energy, 1e-20 * scale * turn);

    const Result bent = pushed(bond, {1, vector6(0, 0, 0, 0, 0, angle)}, kinematics);
    const Vector3 force(0, shear * area * b * turn, 0);
    expect_ends(bent, table_8(force, Vector3::Zero(), a, b), rounding);
    EXPECT_NEAR(bent.state.bonds[0].bending_moment / (normal * polar / 2 * turn), 1, rounding);
  }
}

// Radii 0.3 and 0.6 divide the branch 1 : 2. q = C delta with C the inverse of the added flexibilities.
TEST(TwoParticles, SteppedSectionsCoupleShearAndBending) {
  const double young = 2e6, poisson = 0.25, shear_modulus = young / (2 * (1 + poisson));
  const double a = length / 3, b = 2 * length / 3;
  double f11 = 0, f12 = 0, f22 = 0, axial = 0, torsion = 0;
  for (const auto& [l, r, sign] : {std::array{a, 0.3, 1.0}, std::array{b, 0.6, -1.0}}) {
    const double area = std::numbers::pi * r * r, second = area * r * r / 4;
    f11 += l * l * l / (3 * young * second) + 10 * l / (9 * shear_modulus * area);
    f12 += sign * l * l / (2 * young * second);
    f22 += l / (young * second);
    axial += l / (young * area);
    torsion += l / (shear_modulus * 2 * second);
  }
  const double d = f11 * f22 - f12 * f12;
  const Vector6 by = vector6(1e-4, 2e-4, -3e-4, 4e-4, -5e-4, 6e-4);
  const double dy = by[1] - b * by[5], dz = by[2] + b * by[4];
  const Vector3 force(-by[0] / axial, -(f22 * dy - f12 * by[5]) / d, -(f22 * dz + f12 * by[4]) / d);
  const Vector3 moment(-by[3] / torsion, -(f11 * by[4] + f12 * dz) / d, -(f11 * by[5] - f12 * dy) / d);
  const Ends expected = table_8(force, moment, a, b);
  const BondBlock bond = block("two-segment", {{"young", young}, {"poisson", poisson}});
  expect_ends(pushed(bond, {1, by}, Kinematics::small, 512, 0.6), expected, 1e-12);
  const Result finite = pushed(bond, {1, 1e-6 * by}, Kinematics::finite, 512, 0.6);
  expect_ends(finite, {1e-6 * expected.a, 1e-6 * expected.b}, 1e-8);  // second order in the motion
}

}  // namespace
}  // namespace bondstatic::test
