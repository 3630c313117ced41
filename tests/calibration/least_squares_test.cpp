// The minimiser on functions whose minima are known.
#include "calibration/least_squares.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "bondstatic/error.hpp"
#include "calibration/plain_functions.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;

MatrixXd random_matrix(std::mt19937_64& random, Eigen::Index rows, Eigen::Index columns) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// Rosenbrock's valley: minimum 0 at (1, 1).
const PlainFunction valley{[](const VectorXd& x) {
                             return VectorXd{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}};
                           },
                           [](const VectorXd& x) {
                             return MatrixXd{{-20 * x[0], 10}, {-1, 0}};
                           }};

TEST(LeastSquares, LinearOnesTakeOneStep) {
  std::mt19937_64 random(1);
  const MatrixXd a = random_matrix(random, 7, 3);
  const VectorXd b = 0.1 * random_matrix(random, 7, 1);
  Asked asked;
  const Minimum found = minimise(least_squares(linear(a, b), VectorXd::Zero(3), 100, asked));
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_LT((found.x - a.householderQr().solve(b)).norm(), 1e-11);
  EXPECT_LE(asked.points.size(), 3u);
  EXPECT_THAT(found.held, ElementsAre(false, false, false));
}

TEST(LeastSquares, RosenbrocksValleyEndsAtRounding) {
  Asked asked;
  const Minimum found = minimise(least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked));
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_LT((found.x - VectorXd::Ones(2)).norm(), 1e-12);
  EXPECT_LT(asked.points.size(), 30u);
}

TEST(LeastSquares, JacobiansAreAskedOfBetterPointsOnly) {
  Asked asked;
  const Minimum found = minimise(least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked));
  double best = INFINITY;
  int better = 0;
  for (const VectorXd& x : asked.points) {
    const double here = cost(Loss::squares, valley.residuals(x));
    if (here >= best) continue;
    best = here;
    ++better;
  }
  EXPECT_LE(asked.jacobians, better);
  EXPECT_GT(int(asked.points.size()), asked.jacobians);
  EXPECT_EQ(cost(Loss::squares, found.residuals), best);
}

TEST(LeastSquares, NoPointIsAskedTwice) {
  Asked asked;
  minimise(least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked));
  for (std::size_t i = 0; i < asked.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(asked.points[i], asked.points[j]);
}

// With x1 <= 0.5 the minimum along the edge, not the projection of the free one.
TEST(LeastSquares, ActiveBoundsLeaveTheOthersAtTheirMinimum) {
  const MatrixXd a{{1, 0.9}, {0.9, 1}, {0.3, -0.2}};
  const VectorXd b = a * VectorXd{{2, -1}} + VectorXd{{0.01, -0.02, 0.03}};
  Asked asked;
  LeastSquares problem = least_squares(linear(a, b), VectorXd::Zero(2), 10, asked);
  problem.upper[0] = 0.5;
  const Minimum found = minimise(problem);
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_EQ(found.x[0], 0.5);
  const double other = a.col(1).dot(b - 0.5 * a.col(0)) / a.col(1).squaredNorm();
  EXPECT_NEAR(found.x[1], other, 1e-10);
  EXPECT_THAT(found.held, ElementsAre(true, false));
  EXPECT_LE(asked.points.size(), 6u);
}

TEST(LeastSquares, ABoundThatDoesNotPullAnyMoreLetsGo) {
  // From the corner the gradient leads out over x1's bound; in the end x1 is inside.
  const MatrixXd a{{1, 1}, {0, 0.1}};
  const VectorXd b = a * VectorXd{{0.5, -3}};
  Asked asked;
  LeastSquares problem = least_squares(linear(a, b), VectorXd{{0, 0}}, 10, asked);
  problem.lower[0] = 0;
  const Minimum found = minimise(problem);
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_LT((found.x - VectorXd{{0.5, -3}}).norm(), 1e-10);
  EXPECT_THAT(found.held, ElementsAre(false, false));
}

TEST(LeastSquares, RandomBoxesEndWhereTheConditionsOfOptimalityHold) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const MatrixXd a = random_matrix(random, 6, 4);
    const VectorXd b = 3 * random_matrix(random, 6, 1);
    Asked asked;
    const LeastSquares problem = least_squares(linear(a, b), VectorXd::Zero(4), 0.7, asked);
    const Minimum found = minimise(problem);
    ASSERT_EQ(found.ending, Ending::minimum) << trial;
    const VectorXd gradient = a.transpose() * (a * found.x - b);
    for (Eigen::Index j = 0; j < 4; ++j) {
      if (found.x[j] == problem.lower[j])
        EXPECT_GE(gradient[j], -1e-6) << trial;
      else if (found.x[j] == problem.upper[j])
        EXPECT_LE(gradient[j], 1e-6) << trial;
      else
        EXPECT_NEAR(gradient[j], 0, 1e-6) << trial;
    }
  }
}

// A compliance that is a hundred times too small, and too large, in ln E.
TEST(LeastSquares, FarStartsAreWalkedInStepsThatModelsSurvive) {
  for (const double from : {std::log(100.), -std::log(100.)}) {
    const PlainFunction compliance{[](const VectorXd& x) { return VectorXd{{1e3 * (std::exp(-x[0]) - 1)}}; },
                                   [](const VectorXd& x) { return MatrixXd{{-1e3 * std::exp(-x[0])}}; }};
    Asked asked;
    const Minimum found = minimise(least_squares(compliance, VectorXd{{from}}, 30, asked));
    EXPECT_EQ(found.ending, Ending::minimum);
    EXPECT_NEAR(found.x[0], 0, 1e-12);
    EXPECT_LE(asked.points.size(), 12u);
    double previous = from;
    for (const VectorXd& x : asked.points) {
      EXPECT_LE(std::abs(x[0] - previous), 4.01);
      previous = x[0];
    }
  }
}

TEST(LeastSquares, OutliersMoveARobustFitLittle) {
  const Eigen::Index points = 40;
  const VectorXd t = VectorXd::LinSpaced(points, 0, 1);
  MatrixXd a(points, 2);
  a << VectorXd::Ones(points), t;
  VectorXd b = a * VectorXd{{1, 2}};
  for (Eigen::Index i = 3; i < points; i += 8) b[i] += 200;
  Asked asked;
  LeastSquares problem = least_squares(linear(a, b), VectorXd::Zero(2), 1000, asked);
  EXPECT_GT((minimise(problem).x - VectorXd{{1, 2}}).norm(), 10);
  problem.loss = Loss::huber;
  const Minimum huber = minimise(problem);
  EXPECT_EQ(huber.ending, Ending::minimum);
  EXPECT_LT((huber.x - VectorXd{{1, 2}}).norm(), 1);
  // The minimum of the loss itself: its gradient is gone.
  const VectorXd g = a.transpose() * weights(Loss::huber, huber.residuals).cwiseProduct(huber.residuals);
  EXPECT_LT(g.norm(), 1e-5);
  problem.loss = Loss::cauchy;
  problem.start = huber.x;
  EXPECT_LT((minimise(problem).x - VectorXd{{1, 2}}).norm(), 0.02);
}

// Newton's steps from x = 2 lead beyond -0.05, where there is none.
TEST(LeastSquares, WhereThereIsNoAnswerStepsAreShortened) {
  const PlainFunction saturating{[](const VectorXd& x) { return VectorXd{{1 - std::exp(-x[0])}}; },
                                 [](const VectorXd& x) { return MatrixXd{{std::exp(-x[0])}}; }};
  Asked asked;
  LeastSquares problem = least_squares(saturating, VectorXd{{2}}, 100, asked);
  const auto everywhere = problem.residuals;
  int failed = 0;
  problem.residuals = [&](const VectorXd& x) -> std::optional<VectorXd> {
    if (x[0] > -0.05) return everywhere(x);
    ++failed;
    return {};
  };
  const Minimum found = minimise(problem);
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_NEAR(found.x[0], 0, 1e-12);
  EXPECT_GT(failed, 0);
  EXPECT_LT(asked.points.size(), 15u);
}

TEST(LeastSquares, AWallOfFailuresIsNoMinimum) {
  Asked asked;
  LeastSquares problem = least_squares(linear(MatrixXd::Ones(1, 1), VectorXd{{3}}), VectorXd{{0}}, 10, asked);
  const auto all = problem.residuals;
  problem.residuals = [&](const VectorXd& x) { return x[0] > 1e-30 ? std::nullopt : all(x); };
  EXPECT_EQ(minimise(problem).ending, Ending::stuck);
  problem.most_evaluations = 5;
  EXPECT_EQ(minimise(problem).ending, Ending::too_many_evaluations);
}

TEST(LeastSquares, EvaluationsAreNotExceeded) {
  for (int most = 1; most < 12; ++most) {
    Asked asked;
    LeastSquares problem = least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked);
    problem.most_evaluations = most;
    EXPECT_EQ(minimise(problem).ending, Ending::too_many_evaluations);
    EXPECT_EQ(int(asked.points.size()), most);
  }
}

TEST(LeastSquares, WhatTheFunctionsThrowComesOut) {
  struct Mine {
    int value;
  };
  for (int when = 0; when < 4; ++when)
    for (const bool in_jacobian : {false, true}) {
      Asked asked;
      LeastSquares problem = least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked);
      const auto residuals = problem.residuals;
      const auto jacobian = problem.jacobian;
      int calls = 0;
      if (in_jacobian)
        problem.jacobian = [&] { return calls++ == when ? throw Mine{when} : jacobian(); };
      else
        problem.residuals = [&](const VectorXd& x) {
          return calls++ == when ? throw Mine{when} : residuals(x);
        };
      try {
        minimise(problem);
        ADD_FAILURE() << "nothing came out";
      } catch (const Mine& mine) {
        EXPECT_EQ(mine.value, when);
        EXPECT_EQ(calls, when + 1);
      }
    }
}

TEST(LeastSquares, UnseenDirectionsStayWhereTheyAre) {
  // Only x0 + 2 x1 counts, and x2 not at all.
  const MatrixXd a{{1, 2, 0}, {-0.5, -1, 0}, {3, 6, 0}};
  const VectorXd b{{4, -2, 12.5}};
  Asked asked;
  const Minimum found = minimise(least_squares(linear(a, b), VectorXd{{0.2, 0.1, 0.7}}, 50, asked));
  EXPECT_EQ(found.ending, Ending::minimum);
  EXPECT_NEAR(a.row(0).dot(found.x), 4 + 3 * 0.5 / (1 + 0.25 + 9), 1e-7);
  EXPECT_LT(found.x.norm(), 10);
  EXPECT_EQ(found.x[2], 0.7);
}

TEST(LeastSquares, NothingIsWrittenToStandardError) {
  testing::internal::CaptureStderr();
  Asked asked;
  LeastSquares problem = least_squares(linear(MatrixXd::Ones(1, 1), VectorXd{{3}}), VectorXd{{0}}, 10, asked);
  const auto all = problem.residuals;
  problem.residuals = [&](const VectorXd& x) { return x[0] > 1e-30 ? std::nullopt : all(x); };
  minimise(problem);
  minimise(least_squares(valley, VectorXd{{-1.2, 1}}, 10, asked));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace bondstatic::test
