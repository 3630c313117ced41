// How often the 95 % intervals hold the truth, and what they are where that is known.
#include "calibration/intervals.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calibration/coverage.hpp"
#include "calibration/plain_functions.hpp"

namespace bondstatic::test {
namespace {

// y = p0 exp(-p1 t) + p2 at 12 times; x are what PlainFunction moves.
struct Decay {
  VectorXd t = VectorXd::LinSpaced(12, 0, 3);
  VectorXd values(const VectorXd& x) const { return (x[0] * (-x[1] * t.array()).exp() + x[2]).matrix(); }
  MatrixXd slopes(const VectorXd& x) const {
    const Eigen::ArrayXd fall = (-x[1] * t.array()).exp();
    MatrixXd jacobian(t.size(), 3);
    jacobian << fall.matrix(), (-x[0] * t.array() * fall).matrix(), VectorXd::Ones(t.size());
    return jacobian;
  }
};

const std::vector<Eigen::Index> all_three{0, 1, 2};
const int trials = coverage_trials(100);

/// How often each of three parameters is inside of its interval, noise of the given size in `values`.
std::vector<int> hits(const VectorXd& truth, const std::function<VectorXd(const VectorXd&)>& values,
                      const std::function<MatrixXd(const VectorXd&)>& slopes, double size, bool known) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<int> inside(3);
  for (int trial = 0; trial < trials; ++trial) {
    VectorXd measured = values(truth);
    for (double& y : measured) y += size * normal(random);
    const double over = known ? size : 1;
    Asked asked;
    const Minimum found =
        minimise(least_squares({[&](const VectorXd& x) -> VectorXd { return (values(x) - measured) / over; },
                                [&](const VectorXd& x) -> MatrixXd { return slopes(x) / over; }},
                               truth, 100, asked));
    EXPECT_EQ(found.ending, Ending::minimum);
    const Intervals told = intervals(found, Loss::squares, all_three, {}, 0, known);
    for (Eigen::Index j = 0; j < 3; ++j)
      inside[std::size_t(j)] += std::abs(found.x[j] - truth[j]) <= told.half_width[j];
  }
  return inside;
}

TEST(Intervals, CoverLinearTruthsInNinetyFivePerCent) {
  const Decay decay;
  const VectorXd truth{{2, 0.8, 0.3}};
  const MatrixXd a = decay.slopes(truth);
  for (const bool known : {true, false})
    for (const int inside : hits(
             truth, [&](const VectorXd& x) -> VectorXd { return a * x; }, [&](const VectorXd&) { return a; },
             0.05, known))
      expect_coverage(inside, trials);
}

TEST(Intervals, CoverMildlyNonlinearTruthsInNinetyFivePerCent) {
  const Decay decay;
  const VectorXd truth{{2, 0.8, 0.3}};
  for (const bool known : {true, false})
    for (const int inside : hits(
             truth, [&](const VectorXd& x) { return decay.values(x); },
             [&](const VectorXd& x) { return decay.slopes(x); }, 0.02, known))
      expect_coverage(inside, trials);
}

Minimum fitted(const MatrixXd& jacobian, const VectorXd& residuals) {
  return {Ending::minimum, VectorXd::Zero(jacobian.cols()), residuals, jacobian,
          std::vector<bool>(std::size_t(jacobian.cols()))};
}

TEST(Intervals, MeanOfMeasurementsByHand) {
  // Five values, mean 0: t(4; 97.5 %) s / sqrt(5), s^2 = 10/4.
  const VectorXd r{{-2, -1, 0, 1, 2}};
  const Minimum mean = fitted(MatrixXd::Ones(5, 1), r);
  EXPECT_NEAR(intervals(mean, Loss::squares, {0}, {}, 0, false).half_width[0],
              2.7764451051977987 * std::sqrt(2.5 / 5), 1e-13);
  EXPECT_NEAR(intervals(mean, Loss::squares, {0}, {}, 0, true).half_width[0],
              1.959963984540054 / std::sqrt(5.), 1e-14);
}

TEST(Intervals, CorrelationByHand) {
  const Minimum line = fitted(MatrixXd{{1, 0}, {1, 1}, {1, 2}}, VectorXd::Zero(3));
  const Intervals told = intervals(line, Loss::squares, {0, 1}, {}, 0, true);
  EXPECT_NEAR(told.correlation(0, 1), -std::sqrt(0.6), 1e-14);  // -mean(t) / sqrt(mean(t^2))
  EXPECT_EQ(told.correlation(0, 0), 1);
  EXPECT_EQ(told.correlation(0, 1), told.correlation(1, 0));
}

TEST(Intervals, NothingIsCertainWhereNothingTells) {
  const Minimum exact = fitted(MatrixXd{{1, 0}, {1, 1}}, VectorXd::Zero(2));
  EXPECT_TRUE(std::isnan(intervals(exact, Loss::squares, {0, 1}, {}, 0, false).half_width[0]));
  EXPECT_FALSE(std::isnan(intervals(exact, Loss::squares, {0, 1}, {}, 0, true).half_width[0]));
}

TEST(Intervals, WhatIsUnseenOrHeldIsNaNAndTheOthersKeepTheirs) {
  // x0 and x1 only as a sum, x2 by itself, x3 held.
  const MatrixXd a{{1, 1, 0, 7}, {1, 1, 1, 3}, {2, 2, 1, 1}, {0, 0, 3, 2}};
  const Intervals told = intervals(fitted(a, VectorXd::Zero(4)), Loss::squares, {2}, {0, 1}, 1, true);
  for (const Eigen::Index j : {0, 1, 3}) {
    EXPECT_TRUE(std::isnan(told.half_width[j]));
    EXPECT_TRUE(std::isnan(told.correlation(j, 2)));
  }
  const MatrixXd sum_and_third = a(Eigen::all, {0, 2});
  const MatrixXd covariance = (sum_and_third.transpose() * sum_and_third).inverse();
  EXPECT_NEAR(told.half_width[2], 1.959963984540054 * std::sqrt(covariance(1, 1)), 1e-13);
}

}  // namespace
}  // namespace bondstatic::test
