#include "bondstatic/mechanism.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "mechanism/mechanism_models.hpp"

namespace bondstatic {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = Mechanism::Kind;

// The line through `point` along `axis`, either sense; tolerance relative to the unit lengths of these
// models.
void expect_rotation(const FreeMotion& motion, const Vector3& point, const Vector3& axis) {
  EXPECT_FALSE(motion.translates);
  EXPECT_NEAR(motion.axis.cross(axis.normalized()).norm(), 0, 1e-9);
  EXPECT_NEAR((motion.point - point).cross(motion.axis).norm(), 0, 1e-9);
  EXPECT_EQ(motion.pitch, 0);
}

TEST(Mechanism, SoundCantileverHasNone) {
  Net net;
  net.hold(chain(net, {0, 0, 0}, {0.3, 0.2, 0.1}, 11).front());
  EXPECT_THAT(net.mechanisms(), IsEmpty());
}

TEST(Mechanism, LoneParticleIsIsolated) {
  Net net;
  net.hold(chain(net, {0, 0, 0}, {1, 0, 0}, 3).front());
  net.particle({5, 5, 5});
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::isolated);
  EXPECT_THAT(found[0].particles, ElementsAre(3));
  EXPECT_THAT(found[0].motions, SizeIs(6));
  EXPECT_THAT(unsupported_bodies(net.network, net.dofs()), ElementsAre(ElementsAre(3)));
  EXPECT_THAT(net.mechanisms({false, false, false, true}), IsEmpty());
}

TEST(Mechanism, HeldLoneParticleIsSoundAndHalfHeldOneIsNot) {
  Net net;
  net.hold(net.particle({1, 2, 3}));
  EXPECT_THAT(net.mechanisms(), IsEmpty());
  net.hold(net.particle({7, 2, 3}, 0.25), "xyzu");
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::underconstrained);
  ASSERT_THAT(found[0].motions, SizeIs(2));
  expect_rotation(found[0].motions[0], {7, 2, 3}, Vector3::UnitY());
  expect_rotation(found[0].motions[1], {7, 2, 3}, Vector3::UnitZ());
}

TEST(Mechanism, BodyThatNothingHoldsFloats) {
  Net net;
  net.hold(chain(net, {0, 0, 0}, {1, 0, 0}, 3).front());
  chain(net, {0, 9, 0}, {1, 0, 0}, 4);
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::floating);
  EXPECT_THAT(found[0].particles, ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(found[0].motions, SizeIs(6));
  EXPECT_THAT(unsupported_bodies(net.network, net.dofs()), ElementsAre(ElementsAre(3, 4, 5, 6)));
}

struct HeldDofs {
  std::string first, last;
  Index free_motions;
};
class CantileverHeldBy : public ::testing::TestWithParam<HeldDofs> {};

// A chain along x from the origin to (10, 0, 0).
TEST_P(CantileverHeldBy, LeavesSoManyMotions) {
  Net net;
  const auto bar = chain(net, {0, 0, 0}, {1, 0, 0}, 11);
  net.hold(bar.front(), GetParam().first);
  net.hold(bar.back(), GetParam().last);
  const auto found = net.mechanisms();
  EXPECT_EQ(motions_in_all(found), GetParam().free_motions);
  for (const Mechanism& m : found) {
    EXPECT_EQ(m.kind, Kind::underconstrained);
    EXPECT_THAT(m.particles, SizeIs(11));
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanism, CantileverHeldBy,
                         ::testing::Values(HeldDofs{"xyzuvw", "", 0}, HeldDofs{"xyzuv", "", 1},
                                           HeldDofs{"xyz", "", 3}, HeldDofs{"xyz", "yz", 1},
                                           HeldDofs{"xyz", "xyz", 1}, HeldDofs{"xyzu", "yz", 0},
                                           HeldDofs{"xyzu", "x", 2}, HeldDofs{"yz", "yz", 2},
                                           HeldDofs{"yzu", "yzu", 1}, HeldDofs{"x", "", 5},
                                           HeldDofs{"uvw", "uvw", 3}, HeldDofs{"yuvw", "x", 1}));

TEST(Mechanism, SupportsOnALineLeaveTheRotationAboutIt) {
  Net net;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 4; ++j) {
      const Index p = net.particle({double(i), double(j), 0.3 * double(i * j)});
      if (j > 0) net.bond(p - 1, p);
      if (i > 0) net.bond(p - 4, p);
    }
  for (const Index p : {0, 4, 8, 12}) net.hold(p, "xyz");
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::underconstrained);
  ASSERT_THAT(found[0].motions, SizeIs(1));
  expect_rotation(found[0].motions[0], {0, 0, 0}, Vector3::UnitX());
  net.hold(5, "z");
  EXPECT_THAT(net.mechanisms(), IsEmpty());
}

class Offset : public ::testing::TestWithParam<double> {};

// Three supports, the middle one off the line of the others.
TEST_P(Offset, FromTheLineOfSupportsDecidesRelativeToTheBody) {
  for (const double size : {1e-6, 1.0, 1e3}) {
    Net net;
    const Index a = net.particle({0, 0, 0}), b = net.particle({0.5 * size, GetParam() * size, 0}),
                c = net.particle({size, 0, 0}), d = net.particle({0.4 * size, 0.1 * size, 0.6 * size});
    net.bond(a, b), net.bond(b, c), net.bond(b, d);
    for (const Index p : {a, b, c}) net.hold(p, "xyz");
    EXPECT_EQ(net.mechanisms().size(), GetParam() < 1e-9 ? 1u : 0u) << "size " << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanism, Offset, ::testing::Values(0, 1e-15, 1e-12, 1e-6, 1e-3));

TEST(Mechanism, MissingDirectionIsNamedAsTranslation) {
  Net net;
  const auto bar = chain(net, {3, 0, 0}, {0, 0, 1}, 5);
  net.hold(bar[0], "xyuvw");
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  ASSERT_THAT(found[0].motions, SizeIs(1));
  EXPECT_TRUE(found[0].motions[0].translates);
  EXPECT_EQ(found[0].motions[0].axis, Vector3::UnitZ());
  EXPECT_THAT(describe(net.model, found[0]),
              HasSubstr("body of particles 1, 2, 3, 4, 5 is free to translate along (0, 0, 1)"));
}

TEST(Mechanism, ParticleOnOneContactBondTurnsAboutTheContact) {
  Net net;
  const auto frame = chain(net, {0, 0, 0}, {1, 0, 0}, 6);
  net.hold(frame.front());
  const Index hangs = net.particle({3, 1, 0});
  net.bond(frame[3], hangs, contact, 0.25);
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::internal);
  EXPECT_THAT(found[0].particles, ElementsAre(hangs));
  ASSERT_THAT(found[0].motions, SizeIs(3));
  for (int i = 0; i < 3; ++i)
    expect_rotation(found[0].motions[std::size_t(i)], {3, 0.25, 0}, Vector3::Unit(i));
}

TEST(Mechanism, ParticleBetweenTwoCollinearContactsSpins) {
  Net net;
  const Vector3 along = Vector3(1, 2, -0.5).normalized();
  const Index a = net.particle(-along), spins = net.particle({0, 0, 0}), b = net.particle(along);
  net.bond(a, spins, contact), net.bond(spins, b, contact);
  net.hold(a), net.hold(b);
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].particles, ElementsAre(spins));
  ASSERT_THAT(found[0].motions, SizeIs(1));
  expect_rotation(found[0].motions[0], {0, 0, 0}, along);
}

TEST(Mechanism, ThreeContactsHoldAParticleUnlessTheyLackFriction) {
  for (const auto& law : {contact, frictionless}) {
    Net net;
    const Index rests = net.particle({0, 0, 0.8});
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi * i / 3;
      const Index p = net.particle({std::cos(angle), std::sin(angle), 0});
      net.hold(p);
      net.bond(p, rests, law);
    }
    const auto found = net.mechanisms();
    // Without friction the centre is held and the particle spins freely about it.
    ASSERT_EQ(motions_in_all(found), law.ks > 0 ? 0 : 3);
    for (const Mechanism& m : found)
      for (const FreeMotion& motion : m.motions) expect_rotation(motion, {0, 0, 0.8}, motion.axis);
  }
}

TEST(Mechanism, HingeBetweenTwoBeamBodiesIsFound) {
  Net net;
  const auto held = chain(net, {0, 0, 0}, {1, 0, 0}, 5), swings = chain(net, {0, 0, 2}, {1, 0, 0}, 5);
  net.hold(held.front());
  net.bond(held[1], swings[1], contact);
  net.bond(held[3], swings[3], contact);
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Kind::internal);
  EXPECT_EQ(found[0].particles, swings);
  ASSERT_THAT(found[0].motions, SizeIs(1));
  expect_rotation(found[0].motions[0], {0, 0, 1}, Vector3::UnitX());
}

TEST(Mechanism, ScrewOfAGuidedBodyHasItsPitch) {
  // Wrenches reciprocal to a screw about x: a stepped section where ks kb = coupling^2 transmits q_y and
  // m_z = (coupling / ks) q_y only, so dy + drz * coupling / ks stays free to cancel.
  Net net;
  const Index a = net.particle({0, 0, 0}), b = net.particle({2, 0, 0});
  net.bond(a, b, {1, 4, 1, 1, 2});
  net.hold(a);
  EXPECT_EQ(motions_in_all(net.mechanisms()), 2);
  net.network.links[0].stiffness.kb = 1.0001;
  EXPECT_THAT(net.mechanisms(), IsEmpty());
}

TEST(Mechanism, GenericBondsFailByTheirZeros) {
  for (int zero = 0; zero < 4; ++zero) {
    SectionStiffness law{1e8, 1e-3, 5, 1e12, 0};
    (zero == 0 ? law.kn : zero == 1 ? law.ks : zero == 2 ? law.kt : law.kb) = 0;
    Net net;
    const Index a = net.particle({0, 0, 0}), b = net.particle({0, 0, 2});
    net.bond(a, b, law);
    net.hold(a);
    const auto found = net.mechanisms();
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found[0].motions, SizeIs(zero == 0 || zero == 2 ? 1 : 2));
    EXPECT_EQ(found[0].motions[0].translates, zero < 2);
  }
}

class PinJointedRing : public ::testing::TestWithParam<int> {};

// In its plane (z, rx, ry held) a polygon of n pins keeps n - 3 shapes; three degrees of freedom hold it.
TEST_P(PinJointedRing, KeepsItsShapesWithoutFriction) {
  const int n = GetParam();
  Net net;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.1) / n;
    net.particle({std::cos(angle), std::sin(angle), 0});
    net.hold(i, "zuvw");
  }
  for (int i = 0; i < n; ++i) net.bond(i, (i + 1) % n, frictionless);
  net.hold(0, "xy");
  net.hold(1, "y");
  const auto found = net.mechanisms();
  EXPECT_EQ(motions_in_all(found), n - 3);
  for (const Mechanism& m : found) EXPECT_EQ(m.kind, Kind::internal);
}

// With friction the particles roll on each other like gears: that works only round an even ring. In its plane
// 3n degrees of freedom less 2n contacts and three supports leave n - 3 and the motions whose constraints
// depend.
TEST_P(PinJointedRing, CountsAsBruteForceDoesWithFriction) {
  const int n = GetParam();
  for (const bool held : {true, false}) {
    Net net;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.1) / n;
      net.particle({std::cos(angle), std::sin(angle), 0});
      net.hold(i, held ? "zuv" : "z");
    }
    for (int i = 0; i < n; ++i) net.bond(i, (i + 1) % n, contact);
    net.hold(0, "xyw");
    double gap = 0;
    const Index expected = brute_force_motions(net, std::vector<bool>(std::size_t(n), true), gap).cols();
    EXPECT_EQ(motions_in_all(net.mechanisms()), expected);
    if (held) {
      EXPECT_EQ(expected, n == 3 ? 0 : n - 3);
    }
    EXPECT_GT(gap, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanism, PinJointedRing, ::testing::Range(3, 13));

TEST(Mechanism, HelixOfBeamsIsSound) {
  Net net;
  for (Index i = 0; i < 200; ++i) {
    const double angle = 0.3 * double(i);
    net.particle({std::cos(angle), std::sin(angle), 0.05 * double(i)});
    if (i > 0) net.bond(i - 1, i, {1e9, 1e-3, 1e4, 1e-8, 0});
  }
  net.hold(0);
  EXPECT_THAT(net.mechanisms(), IsEmpty());
}

TEST(Mechanism, LongChainAndLatticeAreSoundAndQuick) {
  const auto start = std::chrono::steady_clock::now();
  Net net;
  net.hold(chain(net, {0, 0, 0}, {0.6, 0.64, 0.48}, 10001).front());
  EXPECT_THAT(net.mechanisms(), IsEmpty());
  Net lattice;
  for (Index p = 0; p < 8000; ++p) {
    const Index i = p % 20, j = p / 20 % 20, k = p / 400;
    lattice.particle({double(i), double(j), double(k)});
    if (i > 0) lattice.bond(p - 1, p);
    if (j > 0) lattice.bond(p - 20, p);
    if (k > 0) lattice.bond(p - 400, p);
    if (k == 0) lattice.hold(p);
  }
  EXPECT_THAT(lattice.mechanisms(), IsEmpty());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 2);
}

TEST(Mechanism, ChainOfHingedBarsCountsEveryJoint) {
  // 300 bars pinned at both ends to their neighbours: each adds three rotations. The spin of a bar about its
  // own line and, of the last, any rotation about its pin are its own affair; the others move many bars
  // together, one overlapping the next, so that they make one mechanism.
  Net net;
  Index last = net.particle({0, 0, 0});
  net.hold(last);
  for (int bar = 0; bar < 300; ++bar) {
    const auto next = chain(net, net.at(last) + Vector3(1, 0.1 * (bar % 3), 0), {1, 0, 0.2}, 4);
    net.bond(last, next.front(), contact);
    last = next.back();
  }
  const auto found = net.mechanisms();
  EXPECT_EQ(motions_in_all(found), 900);
  ASSERT_THAT(found, SizeIs(301));
  EXPECT_THAT(found[0].particles, SizeIs(4));
  EXPECT_THAT(found[0].motions, SizeIs(1));
  EXPECT_THAT(found[299].motions, SizeIs(3));
  EXPECT_THAT(found[300].motions, SizeIs(598));
}

TEST(Mechanism, BondsRoundAPeriodicCellHoldRotations) {
  // A straight chain that closes on its own image: it cannot turn across its axis, but it can turn about it.
  Net net;
  const auto bar = chain(net, {0, 0, 0}, {1, 0, 0}, 4);
  net.network.links.push_back({bar[3], bar[0], Vector3(1, 0, 0), 0.5, beam});
  net.hold(bar[0], "xyz");
  const auto found = net.mechanisms();
  ASSERT_THAT(found, SizeIs(1));
  ASSERT_THAT(found[0].motions, SizeIs(1));
  expect_rotation(found[0].motions[0], {0, 0, 0}, Vector3::UnitX());
}

TEST(Mechanism, MessageNamesIdsMotionAndCure) {
  Net net;
  net.hold(chain(net, {0, 0, 0}, {1, 0, 0}, 12).front(), "xyzuw");
  net.particle({0, 5, 0});
  chain(net, {0, 9, 0}, {1, 0, 0}, 2);
  for (auto& p : net.model.particles) p.id += 100;
  const MechanismError error(net.model, net.mechanisms());
  EXPECT_EQ(error.code(), ExitCode::mechanism);
  EXPECT_THAT(error.mechanisms(), SizeIs(3));
  const std::string what = error.what();
  EXPECT_THAT(what,
              HasSubstr("body of particles 101, 102, 103, 104, 105, 106, 107, 108 ... (12 in all) is free to "
                        "rotate about the line through (0, 0, 0) along (0, 1, 0)"));
  EXPECT_THAT(what, HasSubstr("particle 113 has neither bond nor support"));
  EXPECT_THAT(what, HasSubstr("body of particles 114, 115 is held by no support"));
  EXPECT_THAT(what, HasSubstr("hold one more degree of freedom"));
  EXPECT_THAT(what, HasSubstr("unsupported = \"drop\""));
}

TEST(Mechanism, LongListsAreCut) {
  Net net;
  for (int i = 0; i < 25; ++i) net.particle({double(i), 0, 0});
  const std::string what = MechanismError(net.model, net.mechanisms()).what();
  EXPECT_THAT(what, HasSubstr("particle 10 has"));
  EXPECT_THAT(what, ::testing::Not(HasSubstr("particle 11 has")));
  EXPECT_THAT(what, HasSubstr("and 15 more"));
  EXPECT_EQ(what.find("cure:"), what.rfind("cure:"));
}

}  // namespace
}  // namespace bondstatic
