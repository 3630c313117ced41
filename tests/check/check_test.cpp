// The certificate: that it is given where it is due, and only there.
#include "bondstatic/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bondstatic/network.hpp"
#include "check/differences.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// Two layers of particles, pushed and twisted, in two load cases of which the second also moves a support.
Model packing(double load_factor = 1) {
  std::mt19937_64 random(77);
  Model model = random_packing(random, 2, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}}));
  for (Particle& particle : model.particles) particle.density = 2000;
  model.load_cases = {"push", "twist"};
  fix_all(model, 0);
  fix_all(model, 1);
  model.supports.push_back(
      {2, {true, false, false, false, false, false}, load_factor * vector6(1e-4, 0, 0), 1});
  load(model, 7, load_factor * vector6(1e3, -2e3, 3e3), 0);
  load(model, 6, load_factor * vector6(0, 0, 0, 500, 500, -500), 1);
  return model;
}

Model case_1(double times = 1) {
  Model model = chain(block("timoshenko", {{"young", 200e9}, {"poisson", 0.3}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(4, 0, 0), 10, 0.2);
  for (Particle& particle : model.particles) particle.density = 7850;
  load(model, 10, vector6(0, -times * 100e3, 0));
  return model;
}

RelaxOptions with(Kinematics kinematics) {
  RelaxOptions options;
  options.kinematics = kinematics;
  return options;
}

/// What check() was doing, each part once.
struct Parts {
  std::vector<std::string> seen;
  CheckProgress watch() {
    return [this](const std::string& part, const RelaxProgress*) {
      if (seen.empty() || seen.back() != part) seen.push_back(part);
      return true;
    };
  }
};

TEST(Check, PassesWithSmallKinematics) {
  Parts parts;
  const Certificate certificate = check(packing(), one_thread(), with(Kinematics::small), parts.watch());
  EXPECT_TRUE(certificate.agrees());
  EXPECT_THAT(parts.seen, ElementsAre("static", "run"));
  ASSERT_EQ(certificate.cases.size(), 2u);
  EXPECT_EQ(certificate.cases[0].name, "push");
  EXPECT_EQ(certificate.cases[1].name, "twist");
  for (const CaseCertificate& one : certificate.cases) {
    EXPECT_TRUE(one.agrees) << one.name;
    EXPECT_EQ(one.run.end, RunEnd::at_rest);
    ASSERT_EQ(one.fields.size(), 7u);
    for (const FieldDifference& field : one.fields) {
      EXPECT_GT(field.largest, 0) << field.field;  // a run through time ends near the answer, not on it
      EXPECT_LE(field.largest, 1e-7) << one.name << ", " << field.field;
      EXPECT_EQ(field.first_order, field.largest) << field.field;
      EXPECT_TRUE(std::isnan(field.second_order)) << field.field;
    }
  }
  EXPECT_GT(certificate.dynamic_seconds, 0);
  EXPECT_GT(certificate.static_seconds, 0);
}

TEST(Check, PassesWithFiniteKinematicsWhereTheDifferenceIsOfSecondOrder) {
  const Certificate certificate = check(packing(), one_thread(), with(Kinematics::finite));
  EXPECT_TRUE(certificate.agrees());
  for (const CaseCertificate& one : certificate.cases) {
    const FieldDifference& displacement = one.fields.front();
    EXPECT_GT(displacement.largest, 1e-5) << one.name;  // far outside the tolerance
    EXPECT_LE(displacement.first_order, 1e-6) << one.name;
    EXPECT_NEAR(displacement.second_order / displacement.largest, 1, 0.05) << one.name;
  }
}

TEST(Check, NeedsNoThirdRunWhereLoadsAreSmall) {
  Parts parts;
  const Certificate certificate = check(packing(1e-2), one_thread(), with(Kinematics::finite), parts.watch());
  EXPECT_TRUE(certificate.agrees());
  EXPECT_THAT(parts.seen, ElementsAre("static", "run", "run at 1/2 of the load"));
  for (const CaseCertificate& one : certificate.cases)
    for (const FieldDifference& field : one.fields) EXPECT_TRUE(std::isnan(field.third_order)) << field.field;
}

// F L^2 / EI = 0.025: across, the third order is 4/35 of its square; along, the second is twice that over
// six.
TEST(Check, TakesAThirdRunWhereThirdOrderIsFelt) {
  Parts parts;
  const double times = 4, a = times * 6.366197723675814e-3;
  const Certificate certificate = check(case_1(times), one_thread(), with(Kinematics::finite), parts.watch());
  EXPECT_TRUE(certificate.agrees());
  EXPECT_THAT(parts.seen, ElementsAre("static", "run", "run at 1/2 of the load", "run at 1/4 of the load"));
  const FieldDifference& displacement = certificate.cases.at(0).fields.front();
  EXPECT_LE(displacement.first_order, 1e-6);
  EXPECT_NEAR(displacement.second_order / (a / 5), 1, 0.02);  // a^2 L / 15 over a L / 3
  EXPECT_NEAR(displacement.third_order / (4 * a * a / 35), 1, 0.02);
}

TEST(Check, FailsWhereTheRunIsNotAtRest) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    RelaxOptions options = with(kinematics);
    options.max_steps = 100;
    const Certificate certificate = check(packing(), one_thread(), options);
    EXPECT_FALSE(certificate.agrees());
    for (const CaseCertificate& one : certificate.cases) {
      EXPECT_FALSE(one.agrees) << one.name;
      EXPECT_EQ(one.run.end, RunEnd::step_limit) << one.name;
    }
  }
}

// Near the answer but not at rest is no certificate either.
TEST(Check, FailsWhereAWideToleranceIsMetBeforeRest) {
  RelaxOptions options = with(Kinematics::small);
  options.check_tolerance = 1e9;
  options.max_steps = 100;
  EXPECT_FALSE(check(packing(), one_thread(), options).agrees());
}

TEST(Check, FailsWhereStoppedHalfway) {
  Index looks = 0;
  const Certificate certificate =
      check(packing(), one_thread(), with(Kinematics::small),
            [&looks](const std::string&, const RelaxProgress* run) { return !run || ++looks < 3; });
  EXPECT_EQ(looks, 3);
  EXPECT_FALSE(certificate.agrees());
}

TEST(Check, WithoutAnyCaseIsNoCertificate) {
  EXPECT_FALSE(Certificate{}.agrees());
}

// A run of bonds whose shear stiffness is a ten-thousandth larger must show, with either kinematics.
TEST(Check, WouldNoticeSlightlyWrongBonds) {
  const auto sheared = [](double ks) {
    Model model = packing();
    model.blocks[0] = block("generic", {{"kn", 1e9}, {"ks", ks}, {"kt", 1e8}, {"kb", 1e8}});
    return model;
  };
  constexpr double by = 1e-4;
  const Model exact = sheared(4e8), wrong = sheared(4e8 * (1 + by));
  const StaticSolution statics = solve_statics(exact, one_thread());
  const double length = bond_network(exact, bond_properties(exact)).rotation_length;
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    RelaxOptions options = with(kinematics);
    const Relaxation full = relax(wrong, options, one_thread());
    options.load_factor = 0.5;
    const Relaxation half = relax(wrong, options, one_thread());
    for (std::size_t c = 0; c < 2; ++c) {
      std::vector<ScaledState> runs{{&full.cases[c].state, 1}};
      if (kinematics == Kinematics::finite) runs.push_back({&half.cases[c].state, 0.5});
      const FieldDifference displacement = differences(statics.cases[c], runs, length).front();
      EXPECT_GT(displacement.first_order, 0.05 * by);
      EXPECT_LT(displacement.first_order, 1.05 * by);
    }
  }
}

}  // namespace
}  // namespace bondstatic::test
