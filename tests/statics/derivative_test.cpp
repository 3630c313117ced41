// From the derivatives to stiffness numbers to those to law parameters.
#include <gmock/gmock.h>

#include "bondstatic/sensitivity.hpp"

namespace bondstatic {
namespace {

using testing::ElementsAre;

/// Four bonds; the parameter is given to three of them, of which one has a value of its own.
struct Example {
  BondGradients gradient = BondGradients(4);
  ParameterDerivative parameter{{0, 2, 3},
                                {{{1, 2, 3, 4, 5}, 6}, {{10, 20, 30, 40, 50}, 60}, {{7, 0, 0, 0, 0}, 0}},
                                {false, true, false}};

  Example() {
    for (BondGradient& bond : gradient) bond = {{1, 10, 100, 1000, 10000}, 100000};
  }
};

TEST(Derivative, IsTheSumOverTheBondsThatFollowTheirBlock) {
  const Example example;
  EXPECT_EQ(derivative(example.gradient, example.parameter), 654321 + 7);
}

TEST(Derivative, ByBondHasThoseOfTheirOwnToo) {
  const Example example;
  EXPECT_THAT(derivative_by_bond(example.gradient, example.parameter), ElementsAre(654321, 6543210, 7));
}

TEST(Derivative, KeepsWhatIsLeftWhereTermsCancel) {
  Example example;
  // Within a bond, and over bonds; no product is a double.
  const double third = 1.0 / 3;
  example.gradient[0] = {{third, -third, 0, 0, 0}, 1};
  example.parameter.of_bond[0] = {{1e16 * third, 1e16 * third, 0, 0, 0}, 0x1p-60};
  EXPECT_THAT(derivative_by_bond(example.gradient, example.parameter).front(), 0x1p-60);
  example.gradient[0] = {{third, 0, 0, 0, 0}, 1};
  example.gradient[3] = {{-third, 0, 0, 0, 0}, 0};
  example.parameter.of_bond[2] = {{1e16 * third, 0, 0, 0, 0}, 0};
  example.parameter.of_bond[0] = {{1e16 * third, 0, 0, 0, 0}, 0x1p-40};
  EXPECT_EQ(derivative(example.gradient, example.parameter), 0x1p-40);
}

TEST(Derivative, IsZeroForAParameterThatNoBondTakes) {
  EXPECT_EQ(derivative(BondGradients(3), {}), 0);
  EXPECT_THAT(derivative_by_bond(BondGradients(3), {}), testing::IsEmpty());
}

}  // namespace
}  // namespace bondstatic
