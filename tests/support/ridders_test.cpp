#include "support/ridders.hpp"

#include <gtest/gtest.h>

namespace bondstatic::test {
namespace {

TEST(Ridders, FindsDerivativesAndSaysHowWell) {
  const auto expect = [](const Difference& found, double exact) {
    EXPECT_NEAR(found.value / exact, 1, 1e-12);
    EXPECT_LE(std::abs(found.value - exact), 10 * found.error + 1e-14 * std::abs(exact));
    EXPECT_LE(found.error, 1e-11 * std::abs(exact));
  };
  expect(ridders([](double x) { return std::exp(x); }, 1, 0.5), std::exp(1.0));
  expect(ridders([](double x) { return std::sin(x); }, 0.3, 0.3), std::cos(0.3));
  expect(ridders([](double x) { return 1 / x; }, 7e10, 7e9), -1 / 7e10 / 7e10);
}

TEST(Ridders, SaysWhereThereIsNoDerivative) {
  EXPECT_GT(ridders([](double x) { return std::sqrt(std::abs(x - 1e-3)); }, 0, 0.1).error, 1e-3);
}

}  // namespace
}  // namespace bondstatic::test
