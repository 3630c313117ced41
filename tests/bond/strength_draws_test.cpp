// Strengths that scatter: their distributions, and what a draw depends on.
#include <algorithm>
#include <random>

#include "bond/strength/draws.hpp"
#include "bond/strength_fixture.hpp"

namespace bondstatic {
namespace {

using Scatter = BondStrength::Scatter;

constexpr int draws = 100000;

std::vector<double> sample(Scatter scatter, double given, double spread, std::uint64_t stream = 0) {
  std::vector<double> out;
  for (Index k = 0; k < draws; ++k)
    out.push_back(drawn_strength(scatter, given, spread, bond_key(1, k, k + 1, 0), stream));
  return out;
}

/// Largest distance between the sample's distribution function and `cdf` (Kolmogorov).
double distance(std::vector<double> values, const std::function<double(double)>& cdf) {
  std::sort(values.begin(), values.end());
  double worst = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const std::size_t step : {i, i + 1})
      worst = std::max(worst, std::abs(cdf(values[i]) - double(step) / double(values.size())));
  return worst;
}

/// A sample of the right distribution is further away once in a thousand seeds.
const double far = 1.95 / std::sqrt(double(draws));

double standard_normal_cdf(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

double deviation_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / double(values.size() - 1));
}

TEST(StrengthDraws, NormalHasItsMeanAndCoefficientOfVariation) {
  const std::vector<double> values = sample(Scatter::normal, 5e6, 0.1);
  // Four standard deviations of the mean and of the deviation of a normal sample.
  EXPECT_NEAR(mean_of(values) / 5e6, 1, 4 * 0.1 / std::sqrt(draws));
  EXPECT_NEAR(deviation_of(values) / 5e6, 0.1, 4 * 0.1 / std::sqrt(2.0 * draws));
  EXPECT_LT(distance(values, [](double x) { return standard_normal_cdf((x / 5e6 - 1) / 0.1); }), far);
}

TEST(StrengthDraws, NormalIsDrawnAgainUntilItIsPositive) {
  const std::vector<double> values = sample(Scatter::normal, 2, 0.8);  // 10.6 % would be negative
  EXPECT_GT(*std::min_element(values.begin(), values.end()), 0);
  const double below = standard_normal_cdf(-1 / 0.8);
  EXPECT_LT(
      distance(values,
               [&](double x) { return (standard_normal_cdf((x / 2 - 1) / 0.8) - below) / (1 - below); }),
      far);
}

TEST(StrengthDraws, WeibullHasItsScaleAndModulus) {
  for (const double modulus : {1.5, 8.0}) {
    const std::vector<double> values = sample(Scatter::weibull, 3, modulus);
    EXPECT_LT(distance(values, [&](double x) { return 1 - std::exp(-std::pow(x / 3, modulus)); }), far);
    EXPECT_NEAR(mean_of(values), 3 * std::tgamma(1 + 1 / modulus),
                4 * deviation_of(values) / std::sqrt(draws));
    // 63 % are below the scale: binomial, four standard deviations.
    const double below = double(std::count_if(values.begin(), values.end(), [](double x) { return x < 3; }));
    const double part = 1 - std::exp(-1.0);
    EXPECT_NEAR(below / draws, part, 4 * std::sqrt(part * (1 - part) / draws));
  }
}

TEST(StrengthDraws, UniformKeepsToItsRange) {
  const std::vector<double> values = sample(Scatter::uniform, 10, 4);
  EXPECT_GE(*std::min_element(values.begin(), values.end()), 6);
  EXPECT_LE(*std::max_element(values.begin(), values.end()), 14);
  EXPECT_LT(distance(values, [](double x) { return (x - 6) / 8; }), far);
}

TEST(StrengthDraws, OfTwoStrengthsAreIndependent) {
  const std::vector<double> first = sample(Scatter::normal, 1, 0.1, 0),
                            second = sample(Scatter::normal, 1, 0.1, 1);
  double product = 0;
  for (std::size_t k = 0; k < first.size(); ++k) product += (first[k] - 1) * (second[k] - 1) / 0.01;
  EXPECT_NEAR(product / draws, 0, 4 / std::sqrt(draws));
}

TEST(StrengthDraws, DependOnSeedPairAndOrdinalButNotOnTheEnds) {
  const auto drawn = [](Index seed, Index a, Index b, Index ordinal) {
    return drawn_strength(Scatter::normal, 1, 0.1, bond_key(seed, a, b, ordinal), 0);
  };
  EXPECT_EQ(drawn(1, 5, 9, 0), drawn(1, 9, 5, 0));
  EXPECT_NE(drawn(1, 5, 9, 0), drawn(2, 5, 9, 0));
  EXPECT_NE(drawn(1, 5, 9, 0), drawn(1, 5, 10, 0));
  EXPECT_NE(drawn(1, 5, 9, 0), drawn(1, 4, 9, 0));
  EXPECT_NE(drawn(1, 5, 9, 0), drawn(1, 5, 9, 1));
}

TEST(StrengthDraws, LeaveAloneWhatDoesNotScatter) {
  const std::uint64_t key = bond_key(1, 2, 3, 0);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(drawn_strength(Scatter::none, 5, 0.5, key, 0), 5);
  for (const Scatter scatter : {Scatter::normal, Scatter::uniform, Scatter::weibull}) {
    EXPECT_EQ(drawn_strength(scatter, 5, 0, key, 0), 5);
    EXPECT_EQ(drawn_strength(scatter, inf, 0.5, key, 0), inf);
  }
}

TEST(StrengthDraws, GiveUpWhereNothingIsPositiveAndFinite) {
  EXPECT_TRUE(std::isnan(drawn_strength(Scatter::weibull, 1, 1e-300, bond_key(1, 2, 3, 0), 0)));
}

TEST(OrdinalsInPair, CountBondsBetweenTheSameParticles) {
  Model model;
  for (const auto& [a, b] :
       std::vector<std::pair<Index, Index>>{{0, 1}, {2, 1}, {1, 0}, {3, 3}, {0, 1}, {1, 2}, {3, 3}})
    model.bonds.push_back({Index(model.bonds.size()), a, b});
  EXPECT_EQ(ordinals_in_pair(model), (std::vector<Index>{0, 0, 1, 0, 2, 1, 1}));
}

}  // namespace
}  // namespace bondstatic
