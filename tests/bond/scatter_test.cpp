// The scatter of edem-v2: a function of seed and pair, uniform in stiffness +- range.
#include "bond/laws/scatter.hpp"

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

SectionStiffness draw(double seed, Index a, Index b, double normal_range = 4, double shear_range = 1) {
  const Inputs inputs{{"normal_stiffness", 10}, {"shear_stiffness", 3},         {"seed", seed},
                      {"torque_feedback", 1},   {"normal_range", normal_range}, {"shear_range", shear_range}};
  return evaluate("edem-v2", inputs, {2, 1, 1, a, b}).stiffness;
}

const double area = draw(1, 1, 2, 0, 0).kn / 10;

TEST(SplitMix64, GivesThePublishedSequence) {
  // First outputs of the reference implementation for seed 1234567.
  const std::uint64_t golden = 0x9e3779b97f4a7c15u;
  EXPECT_EQ(splitmix64(1234567), 6457827717110365317u);
  EXPECT_EQ(splitmix64(1234567 + golden), 3203168211198807973u);
  EXPECT_EQ(splitmix64(1234567 + 2 * golden), 9817491932198370423u);
}

TEST(EdemScatter, IsUniformWithinTheRange) {
  const int bonds = 20000;
  double mean = 0, square = 0, shear_mean = 0, product = 0, low = 1, high = -1;
  for (int k = 0; k < bonds; ++k) {
    const SectionStiffness c = draw(1, k, k + 1);
    const double n = (c.kn / area - 10) / 4, s = c.ks / area - 3;
    ASSERT_LE(std::abs(n), 1 + 1e-14);
    ASSERT_LE(std::abs(s), 1 + 1e-14);
    EXPECT_NEAR(c.kb, c.kn / 4, 1e-14 * c.kb);  // r = 1: the moments follow the same draw
    EXPECT_NEAR(c.kt, c.ks / 2, 1e-14 * c.kt);
    mean += n / bonds;
    shear_mean += s / bonds;
    square += n * n / bonds;
    product += n * s / bonds;
    low = std::min(low, n);
    high = std::max(high, n);
  }
  // Four standard deviations of the mean of 20000: variance 1/3, of the square 4/45, of the product 1/9.
  EXPECT_NEAR(mean, 0, 4 * std::sqrt(1.0 / 3 / bonds));
  EXPECT_NEAR(shear_mean, 0, 4 * std::sqrt(1.0 / 3 / bonds));
  EXPECT_NEAR(square, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / bonds));
  EXPECT_NEAR(product, 0, 4 * std::sqrt(1.0 / 9 / bonds));
  EXPECT_LT(low, -0.999);
  EXPECT_GT(high, 0.999);
}

TEST(EdemScatter, DependsOnSeedAndPairButNotOnTheEnds) {
  EXPECT_EQ(draw(1, 5, 9).kn, draw(1, 9, 5).kn);
  EXPECT_EQ(draw(1, 5, 9).ks, draw(1, 9, 5).ks);
  EXPECT_NE(draw(1, 5, 9).kn, draw(2, 5, 9).kn);
  EXPECT_NE(draw(1, 5, 9).kn, draw(1, 5, 10).kn);
  EXPECT_NE(draw(1, 5, 9).kn, draw(1, 4, 9).kn);
}

TEST(EdemScatter, IsAbsentWithoutARange) {
  EXPECT_EQ(draw(1, 5, 9, 0, 0).kn, draw(2, 7, 8, 0, 0).kn);
  EXPECT_EQ(draw(1, 5, 9, 4, 0).ks, draw(2, 7, 8, 4, 0).ks);
}

}  // namespace
}  // namespace bondstatic
