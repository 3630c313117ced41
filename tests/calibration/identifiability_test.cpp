// Directions that targets do not see, on products of powers and other plain functions.
#include "calibration/identifiability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/plain_functions.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> names{"young", "radius_factor", "kappa"};

// Residuals that are sums of products of powers of exp(x); derivatives by x.
MatrixXd powers(const std::vector<std::vector<VectorXd>>& residuals, const VectorXd& x) {
  MatrixXd jacobian = MatrixXd::Zero(Eigen::Index(residuals.size()), x.size());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    for (const VectorXd& exponents : residuals[i])
      jacobian.row(Eigen::Index(i)) += std::exp(exponents.dot(x)) * exponents.transpose();
  return jacobian;
}

struct Told {
  std::vector<VectorXd> directions;
  std::vector<std::string> sentences;
};

Told tell(const std::vector<std::vector<VectorXd>>& residuals, const VectorXd& start, const VectorXd& end) {
  std::vector<Eigen::Index> columns;
  for (Eigen::Index j = 0; j < start.size(); ++j) columns.push_back(j);
  const VectorXd ones = VectorXd::Ones(start.size());
  Told told;
  for (const UnseenDirection& unseen : unseen_directions(powers(residuals, end), columns)) {
    told.directions.push_back(unseen.direction);
    told.sentences.push_back(
        sentence(unseen, names, {powers(residuals, start), ones}, {powers(residuals, end), ones}));
  }
  return told;
}

const VectorXd start{{0.1, -0.3, 0.2}}, end{{0.4, 0.2, -0.1}};

TEST(Identifiability, AProductOfPowersIsNamed) {
  const Told told =
      tell({{VectorXd{{1, 2}}}, {VectorXd{{-1, -2}}}, {VectorXd{{0.5, 1}}}}, start.head(2), end.head(2));
  ASSERT_EQ(told.sentences.size(), 1u);
  EXPECT_EQ(told.sentences[0],
            "young and radius_factor act only through young radius_factor^2 in these tests");
  EXPECT_NEAR(std::abs(told.directions[0].dot(VectorXd{{2, -1}})), std::sqrt(5), 1e-12);
  EXPECT_NEAR(told.directions[0].norm(), 1, 1e-15);
}

TEST(Identifiability, ExponentsAreWholeAndRatiosAreWrittenAsSuch) {
  const auto of = [](double a, double b) {
    return tell({{VectorXd{{a, b}}}, {VectorXd{{2 * a, 2 * b}}}}, start.head(2), end.head(2)).sentences.at(0);
  };
  EXPECT_THAT(of(1, 4), HasSubstr("through young radius_factor^4 in"));
  EXPECT_THAT(of(4, 1), HasSubstr("through young^4 radius_factor in"));
  EXPECT_THAT(of(1, -1), HasSubstr("through young / radius_factor in"));
  EXPECT_THAT(of(1, 1), HasSubstr("through young radius_factor in"));
  EXPECT_THAT(of(2, 3), HasSubstr("through young^2 radius_factor^3 in"));
  EXPECT_THAT(of(1, std::sqrt(2)),
              HasSubstr("cannot be told apart by these tests: at the solution, 1 % more young "
                        "together with 0.707 % less radius_factor changes no target"));
}

TEST(Identifiability, SumsOfPowersThatOneResidualCannotSplitNameNoProduct) {
  // Two residuals of the same sum: a direction at each point, another one at the next.
  const std::vector<VectorXd> sum{VectorXd{{1, 2}}, VectorXd{{1, 4}}};
  const Told told = tell({sum, sum}, start.head(2), end.head(2));
  ASSERT_EQ(told.sentences.size(), 1u);
  EXPECT_THAT(told.sentences[0], Not(HasSubstr("act only")));
  EXPECT_THAT(told.sentences[0], HasSubstr("1 % more young together with"));
}

TEST(Identifiability, APowerAtTheSolutionAloneIsNoInvariant) {
  // d/dx of the second residual vanishes at the solution x = end.
  const MatrixXd at_start{{1, 2}, {0.5, -0.3}}, at_end{{1, 2}, {0, 0}};
  const auto unseen = unseen_directions(at_end, {0, 1});
  ASSERT_EQ(unseen.size(), 1u);
  const VectorXd ones = VectorXd::Ones(2);
  EXPECT_THAT(sentence(unseen[0], names, {at_start, ones}, {at_end, ones}), Not(HasSubstr("act only")));
}

TEST(Identifiability, NoInfluenceIsSaid) {
  const Told told = tell({{VectorXd{{1, 0, 2}}}, {VectorXd{{1, 0, -1}}}, {VectorXd{{3, 0, 1}}}}, start, end);
  ASSERT_EQ(told.sentences.size(), 1u);
  EXPECT_EQ(told.sentences[0], "radius_factor has no influence on any target");
  EXPECT_EQ(told.directions[0], VectorXd::Unit(3, 1));
}

TEST(Identifiability, ThreeParametersInOneProductAreTwoDirections) {
  const VectorXd e{{1, 4, -1}};
  const Told told = tell({{e}, {2 * e}, {-e}}, start, end);
  ASSERT_EQ(told.sentences.size(), 2u);
  EXPECT_EQ(told.sentences[0],
            "young and radius_factor act only through young radius_factor^4 in these tests");
  EXPECT_EQ(told.sentences[1],
            "radius_factor and kappa act only through radius_factor^4 / kappa in these tests");
}

TEST(Identifiability, ThreeParametersInTwoProductsAreOneDirection) {
  const VectorXd a{{1, 2, 0}}, b{{1, 0, -1}};
  const Told told = tell({{a}, {b}, {a, b}, {a + b}}, start, end);
  ASSERT_EQ(told.sentences.size(), 1u);
  EXPECT_THAT(told.sentences[0],
              HasSubstr("young, radius_factor and kappa act only through young radius_factor^2 and "
                        "radius_factor^2 kappa in these tests"));
}

TEST(Identifiability, UnitsAndTolerancesHideNothing) {
  MatrixXd a{{1, 2}, {2, 1}, {1, 1}};
  EXPECT_TRUE(unseen_directions(a, {0, 1}).empty());
  a.row(0) *= 1e5;
  a.col(1) *= 1e-7;
  EXPECT_TRUE(unseen_directions(a, {0, 1}).empty());
  a.col(0) = 1e3 * a.col(1) * (1 + 1e-12);
  EXPECT_EQ(unseen_directions(a, {0, 1}).size(), 1u);
}

TEST(Identifiability, WhatIsHardToTellApartIsNotCalledImpossible) {
  const auto nearly = [](double apart) { return MatrixXd{{1, 1}, {1, 1 + apart}, {1, 1}}; };
  EXPECT_TRUE(unseen_directions(nearly(1e-6), {0, 1}).empty());
  EXPECT_EQ(unseen_directions(nearly(1e-10), {0, 1}).size(), 1u);
}

TEST(Identifiability, ParametersWithoutALogarithmGetAPlainSentence) {
  const MatrixXd a{{1, 2}, {2, 4}};
  const LookedAt at{a, VectorXd{{1, NAN}}};
  const auto unseen = unseen_directions(a, {0, 1});
  EXPECT_EQ(sentence(unseen.at(0), {"young", "poisson"}, at, at),
            "young and poisson cannot be told apart by these tests");
}

}  // namespace
}  // namespace bondstatic::test
