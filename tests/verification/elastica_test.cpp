// Large deflections: explicit runs with finite kinematics against the elastica, as bonds are refined.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "bondstatic/dynamics.hpp"
#include "bondstatic/relaxation.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double pi = std::numbers::pi;

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

struct Rod {
  double length, radius, young = 200e9, poisson = 0.3;

  double axial() const { return young * pi * radius * radius; }
  double bending() const { return axial() * radius * radius / 4; }
  double shear() const { return 0.9 * axial() / (2 * (1 + poisson)); }  // of the Timoshenko bond, h -> 0
};

/// Of the loaded end: how far across and along (towards the root), and by which angle it turned.
struct End {
  double across = 0, along = 0, angle = 0;
};

/// The rod that the chains tend to, by shooting: force P across the root's tangent at the end, Runge-Kutta
/// along the length, secants on the moment at the root. What stretches it is the force along the centre
/// line's tangent, which is off the section's normal by the shear angle. Zero flexibilities leave the
/// elastica.
class TipLoadedRod {
 public:
  TipLoadedRod(double length, double bending, double stretch, double shear, double force)
      : length_(length), bending_(bending), stretch_(stretch), shear_(shear), force_(force) {}

  End end() const {
    double m0 = force_ * length_, m1 = 0.7 * m0;
    double left0 = shoot(m0).moment, left1 = shoot(m1).moment;
    for (int i = 0; i < 60 && left1 != left0 && std::abs(left1) > 1e-15 * force_ * length_; ++i) {
      const double next = m1 - left1 * (m1 - m0) / (left1 - left0);
      m0 = m1, left0 = left1;
      m1 = next, left1 = shoot(m1).moment;
    }
    const Section last = shoot(m1);
    return {last.across, length_ - last.along, last.angle};
  }

 private:
  struct Section {
    double along = 0, across = 0, angle = 0, moment = 0;
    Section plus(const Section& rate, double by) const {
      return {along + by * rate.along, across + by * rate.across, angle + by * rate.angle,
              moment + by * rate.moment};
    }
  };

  Section rate(const Section& at) const {
    double tangent = at.angle;
    for (int i = 0; i < 20 && shear_ > 0; ++i) tangent = at.angle + shear_ * force_ * std::cos(tangent);
    const double stretched = 1 + stretch_ * force_ * std::sin(tangent);
    return {stretched * std::cos(tangent), stretched * std::sin(tangent), at.moment / bending_,
            -force_ * stretched * std::cos(tangent)};
  }

  Section shoot(double root_moment) const {
    constexpr int steps = 1000;
    const double h = length_ / steps;
    Section at{0, 0, 0, root_moment};
    for (int i = 0; i < steps; ++i) {
      const Section a = rate(at), b = rate(at.plus(a, h / 2)), c = rate(at.plus(b, h / 2)),
                    d = rate(at.plus(c, h));
      at = at.plus(a, h / 6).plus(b, h / 3).plus(c, h / 3).plus(d, h / 6);
    }
    return at;
  }

  double length_, bending_, stretch_, shear_, force_;
};

// P L^2 / EI, and w/L, u/L, theta of the elastica by elliptic integrals.
struct Tabulated {
  double load, across, along, angle;
};
constexpr Tabulated table[] = {{1, .301720773799814, .056433236283377, .461351949711879},
                               {2, .493457480396712, .160641720825167, .781749831556543},
                               {5, .713791523611913, .387628360724430, 1.215368117611681}};

TEST(Elastica, ReferenceOfTheseTestsEqualsTheTable) {
  for (const Tabulated& row : table) {
    const End end = TipLoadedRod(1, 1, 0, 0, row.load).end();
    EXPECT_NEAR(end.across, row.across, 1e-12);
    EXPECT_NEAR(end.along, row.along, 1e-12);
    EXPECT_NEAR(end.angle, row.angle, 1e-12);
  }
}

struct Frame {
  Vector3 axis, across;
  Vector3 normal() const { return axis.cross(across); }
};
const Frame straight{{1, 0, 0}, {0, 1, 0}};

struct Push {
  double force = 0, moment = 0;  ///< across, and about the normal, at the end
};

struct Manner {
  double ramp_time = not_given;
  double safety = 0.8;
};

/// The chain at rest under a dead load, clamped at the origin; as heavy as a steel rod whatever the number of
/// bonds.
State at_rest(const Rod& rod, const std::string& law, Index bonds, const Push& push,
              const Frame& frame = straight, const Manner& manner = {}) {
  const double h = rod.length / double(bonds);
  Model model = chain(block(law, {{"young", rod.young}, {"poisson", rod.poisson}, {"radius", rod.radius}}),
                      Vector3::Zero(), rod.length * frame.axis, bonds, h / 2);
  for (Particle& particle : model.particles) particle.density = 7850 * 6 * std::pow(rod.radius / h, 2);
  Vector6 end_load;
  end_load << push.force * frame.across, push.moment * frame.normal();
  load(model, bonds, end_load);
  RelaxOptions options;
  options.ramp = Ramp::smooth;
  options.ramp_time = manner.ramp_time;
  options.safety = manner.safety;
  options.velocity_limit = 1e-7;
  options.force_limit = 1e-9;
  StaticOptions solve;
  solve.threads = 1;
  const RelaxedCase ended = relax(model, options, solve).cases.at(0);
  EXPECT_EQ(ended.end, RunEnd::at_rest);
  return ended.state;
}

/// By the rod's length.
std::array<double, 3> tip_of(const Rod& rod, const State& state, const Frame& frame = straight) {
  const Vector6 u = state.displacement.back();
  return {frame.across.dot(u.head<3>()) / rod.length, -frame.axis.dot(u.head<3>()) / rod.length,
          frame.normal().dot(u.tail<3>())};
}

std::array<double, 3> limit_of(const Rod& rod, const std::string& law, double force) {
  const double shear = law == "timoshenko" ? 1 / rod.shear() : 0;
  const End end = TipLoadedRod(rod.length, rod.bending(), 1 / rod.axial(), shear, force).end();
  return {end.across / rod.length, end.along / rod.length, end.angle};
}

/// The error falls fourfold as bonds are halved, but for higher orders and what the run itself leaves, which
/// is at most `floor`. Returns where the trend leads.
std::array<double, 3> expect_convergence(const Rod& rod, const std::string& law, double force, double floor,
                                         Index finest = 40) {
  const auto limit = limit_of(rod, law, force);
  std::array<double, 3> coarse{}, trend{};
  for (Index n = 10; n <= finest; n *= 2) {
    const auto fine = tip_of(rod, at_rest(rod, law, n, {force, 0}));
    for (std::size_t i = 0; i < 3 && n > 10; ++i) {
      const double before = coarse[i] - limit[i], now = fine[i] - limit[i];
      EXPECT_NEAR(before, 4 * now, 0.05 * std::abs(before) + 3 * floor) << n << " bonds, quantity " << i;
      trend[i] = (4 * fine[i] - coarse[i]) / 3;
    }
    coarse = fine;
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(trend[i], limit[i], floor) << "quantity " << i;
  return trend;
}

class BeamBonds : public ::testing::TestWithParam<const char*> {};

TEST_P(BeamBonds, ConvergeToTheElastica) {
  const Rod rod{1, 0.01};
  const std::string law = GetParam();
  const Index finest = full_run() && law == "timoshenko" ? 80 : 40;  // the other takes four times as long
  for (const Tabulated& row : table) {
    SCOPED_TRACE(row.load);
    const auto trend = expect_convergence(rod, law, row.load * rod.bending(), 3e-7, finest);
    // Stretch and shear, which the elastica leaves out.
    const double slender = row.load * std::pow(rod.radius / rod.length, 2);
    EXPECT_NEAR(trend[0], row.across, slender);
    EXPECT_NEAR(trend[1], row.along, slender);
    EXPECT_NEAR(trend[2], row.angle, slender);
  }
}

// [Chen2022]'s beam, 20 radii long, under 10 and 100 times its 100 kN: F L^2 / EI = 0.064 and 0.64.
TEST_P(BeamBonds, ConvergeForThePapersBeamUnderTenAndAHundredTimesItsLoad) {
  const Rod rod{4, 0.2};
  expect_convergence(rod, GetParam(), 10 * 100e3, 5e-9);
  expect_convergence(rod, GetParam(), 100 * 100e3, 3e-7);  // shear of a stretching bond remembers its path
}

INSTANTIATE_TEST_SUITE_P(Verification, BeamBonds, ::testing::Values("euler-bernoulli", "timoshenko"),
                         [](const auto& law) {
                           return law.param[0] == 'e' ? "EulerBernoulli" : "Timoshenko";
                         });

// Any number of bonds turns by 2 pi in all: the chain is a closed polygon, inscribed in the circle as n
// grows.
TEST(EndMoment, ClosesACircle) {
  const Rod rod{1, 0.01};
  const double moment = 2 * pi * rod.bending();
  double off_before = 0;
  for (const Index n : {8, 16, 32}) {
    const State state = at_rest(rod, "euler-bernoulli", n, {0, moment});
    for (const BondResult& bond : state.bonds) EXPECT_NEAR(bond.bending_moment / moment, 1, 1e-8);
    EXPECT_LT((state.displacement.back().head<3>() + straight.axis).norm(), 1e-6);
    EXPECT_LT(state.displacement.back().tail<3>().norm(), 1e-5);  // a whole turn is none
    const Vector3 farthest = state.displacement[std::size_t(n / 2)].head<3>() + straight.axis / 2;
    EXPECT_NEAR(farthest.norm(), 1 / (double(n) * std::sin(pi / double(n))), 1e-6);
    const double off = farthest.norm() - 1 / pi;
    if (off_before > 0) {
      EXPECT_NEAR(off_before / off, 4, 0.1);
    }
    off_before = off;
  }
}

// Loaded slowly, what is left open is the step's own error.
TEST(EndMoment, ClosesTheBetterTheShorterTheStep) {
  const Rod rod{1, 0.01};
  const auto left_open = [&](double safety) {
    const Vector6 u = at_rest(rod, "euler-bernoulli", 8, {0, 2 * pi * rod.bending()}, straight, {1, safety})
                          .displacement.back();
    EXPECT_LT((u.head<3>() + straight.axis).norm(), 5e-9);
    return u.tail<3>().norm();
  };
  EXPECT_NEAR(left_open(0.8) / left_open(0.4), 4, 0.3);
}

// Increments of moments do not commute: swinging out of the plane, which particle damping excites in a frame
// that is not its own, leaves a twist behind. It fades as the load is applied more slowly.
TEST(TurnedElastica, EqualsTheStraightOneWhenLoadedSlowly) {
  const Rod rod{1, 0.01};
  const Frame turned{{0.6, 0.64, 0.48}, Vector3(-0.64, 0.6, 0).normalized()};
  const double force = 5 * rod.bending();
  const auto expected = tip_of(rod, at_rest(rod, "timoshenko", 10, {force, 0}));
  const auto apart = [&](double ramp_time) {
    const State state = at_rest(rod, "timoshenko", 10, {force, 0}, turned, {ramp_time});
    const auto tip = tip_of(rod, state, turned);
    double size = std::abs(turned.normal().dot(state.displacement.back().head<3>()));
    for (std::size_t i = 0; i < 3; ++i) size = std::max(size, std::abs(tip[i] - expected[i]));
    return size;
  };
  EXPECT_GT(apart(0.03), 1e-5);  // about a period of the slowest mode
  EXPECT_LT(apart(5), 1e-6);
}

}  // namespace
}  // namespace bondstatic::test
