// Orders, places and measures of differences between states made by hand.
#include "check/differences.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double length = 0.5;

/// Three particles and two bonds; all fields of the size of 1 or, where angular, of what `length` makes of
/// it.
State statics() {
  State state;
  state.displacement = {vector6(0, 0, 0), vector6(0.5, 0, 0, 0, 0, 1), vector6(0, -1, 0, 0, 0, 2)};
  state.reaction = {vector6(0, 3, 0, 0, 0, 4), vector6(0, 0, 0), vector6(0, 0, 0)};
  state.bonds.resize(2);
  state.bonds[0].force = vector6(0, 3, 0, 0, 0, 2);
  state.bonds[1].force = vector6(0, 1.5, 0, 0, 0, 1);
  state.energy = 8;
  return state;
}

State scaled(const State& state, double factor) {
  State other = state;
  for (Vector6& u : other.displacement) u *= factor;
  for (Vector6& f : other.reaction) f *= factor;
  for (BondResult& bond : other.bonds) bond.force *= factor;
  other.energy *= factor * factor;
  return other;
}

const FieldDifference& field(const std::vector<FieldDifference>& all, const std::string& name) {
  for (const FieldDifference& one : all)
    if (one.field == name) return one;
  throw std::logic_error("no field " + name);
}

struct Coefficients {
  double first, second, third;
  double at(double s) const { return s * first + s * s * second + s * s * s * third; }
};

/// A run at each factor, off at the last particle and at bond 1 by the planted orders.
struct Planted {
  std::vector<State> runs;
  std::vector<double> factors;

  Planted(const Coefficients& planted, const std::vector<double>& at) : factors(at) {
    for (const double s : at) {
      runs.push_back(scaled(statics(), s));
      State& run = runs.back();
      run.displacement[2] += planted.at(s) * vector6(0.6, 0, 0.8, 0.6, 0.8, 0);
      run.reaction[0] += planted.at(s) * vector6(0, 0, 1, 1, 0, 0);
      run.bonds[1].force += planted.at(s) * vector6(1, 0, 0, 0, 1, 0);
      run.energy += s * planted.at(s);
    }
  }

  std::vector<FieldDifference> differences_found() const {
    std::vector<ScaledState> scaled_runs;
    for (std::size_t k = 0; k < runs.size(); ++k) scaled_runs.push_back({&runs[k], factors[k]});
    return differences(statics(), scaled_runs, length);
  }
};

struct Measured {
  const char* name;
  double size;  // of the static field's largest
};
const Measured measures[] = {{"displacement", 1},    {"rotation", 2},   {"reaction force", 3},
                             {"reaction moment", 4}, {"bond force", 3}, {"bond moment", 2},
                             {"energy", 8}};

// Rounding of numbers of the size of 1, taken apart by weights of up to 30.
constexpr double rounding = 1e-14;

TEST(Differences, OfEqualStatesAreZero) {
  for (const FieldDifference& one : Planted({0, 0, 0}, {1}).differences_found()) {
    EXPECT_EQ(one.largest, 0) << one.field;
    EXPECT_EQ(one.norm, 0) << one.field;
    EXPECT_EQ(one.first_order, 0) << one.field;
  }
}

TEST(Differences, AreAllFirstOrderInASingleRun) {
  const auto found = Planted({1e-3, 2e-3, 3e-3}, {1}).differences_found();
  ASSERT_EQ(found.size(), std::size(measures));
  for (const auto& [name, size] : measures) {
    const FieldDifference& one = field(found, name);
    EXPECT_NEAR(one.first_order, 6e-3 / size, rounding) << name;
    EXPECT_EQ(one.largest, one.first_order) << name;
    EXPECT_TRUE(std::isnan(one.second_order)) << name;
    EXPECT_TRUE(std::isnan(one.third_order)) << name;
  }
}

TEST(Differences, TwoRunsTellFirstFromSecondOrder) {
  const auto found = Planted({1e-3, 2e-3, 0}, {1, 0.5}).differences_found();
  for (const auto& [name, size] : measures) {
    const FieldDifference& one = field(found, name);
    EXPECT_NEAR(one.first_order, 1e-3 / size, rounding) << name;
    EXPECT_NEAR(one.second_order, 2e-3 / size, rounding) << name;
    EXPECT_TRUE(std::isnan(one.third_order)) << name;
  }
}

TEST(Differences, ThreeRunsTellThreeOrdersApart) {
  const auto found = Planted({1e-6, 2e-3, 3e-2}, {1, 0.5, 0.25}).differences_found();
  for (const auto& [name, size] : measures) {
    const FieldDifference& one = field(found, name);
    EXPECT_NEAR(one.first_order, 1e-6 / size, rounding) << name;
    EXPECT_NEAR(one.second_order, 2e-3 / size, rounding) << name;
    EXPECT_NEAR(one.third_order, 3e-2 / size, rounding) << name;
    EXPECT_NEAR(one.largest, (1e-6 + 2e-3 + 3e-2) / size, rounding) << name;
  }
}

TEST(Differences, ThirdOrderSpoilsTheFirstOfTwoRunsByHalf) {
  const auto found = Planted({0, 0, 4e-3}, {1, 0.5}).differences_found();
  EXPECT_NEAR(field(found, "displacement").first_order, 2e-3, rounding);
}

TEST(Differences, NameTheWorstPlace) {
  const auto found = Planted({1e-3, 0, 0}, {1}).differences_found();
  EXPECT_EQ(field(found, "displacement").worst.at, 2);
  EXPECT_FALSE(field(found, "displacement").worst.of_bond);
  EXPECT_EQ(field(found, "reaction moment").worst.at, 0);
  EXPECT_EQ(field(found, "bond force").worst.at, 1);
  EXPECT_TRUE(field(found, "bond force").worst.of_bond);
  EXPECT_EQ(field(found, "energy").worst.at, -1);
}

TEST(Differences, NormsAreOverTheNormOfTheField) {
  const auto found = Planted({1e-3, 0, 0}, {1}).differences_found();
  EXPECT_NEAR(field(found, "displacement").norm, 1e-3 / std::hypot(0.5, 1), rounding);
  EXPECT_NEAR(field(found, "bond moment").norm, 1e-3 / std::hypot(2, 1), rounding);
}

// A field without any magnitude of its own is held against a thousandth of what its kind reaches: rotation by
// the largest displacement over the length, moments by the largest force times it.
TEST(Differences, OfVanishingFieldsAreMeasuredByTheirKind) {
  State exact = statics();
  for (Vector6& u : exact.displacement) u.tail<3>().setZero();
  for (Vector6& f : exact.reaction) f.tail<3>().setZero();
  for (BondResult& bond : exact.bonds) bond.force.tail<3>().setZero();
  State run = exact;
  run.displacement[1][3] = run.reaction[0][3] = run.bonds[0].force[3] = 1e-9;
  const auto found = differences(exact, {{&run, 1}}, length);
  EXPECT_NEAR(field(found, "rotation").largest, 1e-9 / (1e-3 * 1 / length), 1e-20);
  EXPECT_NEAR(field(found, "reaction moment").largest, 1e-9 / (1e-3 * 3 * length), 1e-20);
  EXPECT_NEAR(field(found, "bond moment").largest, 1e-9 / (1e-3 * 3 * length), 1e-20);
  EXPECT_NEAR(field(found, "rotation").norm, field(found, "rotation").largest, 1e-20);
}

TEST(Differences, WithoutAnyLoadAreZeroWhereTheRunIsZeroToo) {
  const State nothing = scaled(statics(), 0);
  for (const FieldDifference& one : differences(nothing, {{&nothing, 1}}, length)) EXPECT_EQ(one.largest, 0);
}

TEST(Differences, SkipWhatWasLeftOut) {
  State exact = statics(), run = scaled(statics(), 1);
  exact.displacement[1].setConstant(not_given);
  exact.reaction[1].setConstant(not_given);
  exact.bonds[0].force.setConstant(not_given);
  run.bonds[0].force.setConstant(not_given);
  run.displacement[1].setConstant(not_given);
  run.displacement[2][1] += 1e-3;
  run.bonds[1].force[1] += 1e-3;
  const auto found = differences(exact, {{&run, 1}}, length);
  EXPECT_NEAR(field(found, "displacement").largest, 1e-3, rounding);
  EXPECT_NEAR(field(found, "displacement").norm, 1e-3, rounding);
  EXPECT_NEAR(field(found, "bond force").largest, 1e-3 / 1.5, rounding);
  EXPECT_EQ(field(found, "reaction force").largest, 0);
}

// A comparison with NaN is false: a run that lost a number must not pass for one that agrees.
TEST(Differences, DoNotHideNumbersThatTheRunLacks) {
  const State exact = statics();
  for (const std::size_t place : {0u, 1u, 2u}) {
    State run = exact;
    run.displacement[place][1] = not_given;
    const FieldDifference one = field(differences(exact, {{&run, 1}}, length), "displacement");
    EXPECT_FALSE(one.first_order <= 1e-6) << "particle " << place;
    EXPECT_FALSE(one.largest <= 1e-6) << "particle " << place;
    EXPECT_FALSE(one.norm <= 1e-6) << "particle " << place;
  }
}

}  // namespace
}  // namespace bondstatic::test
