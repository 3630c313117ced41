// Edge stresses by hand.
#include <numbers>

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using std::numbers::pi;

TEST(SectionStress, IsTensionPlusBendingAndShearPlusTwist) {
  // r = 0.5: A = pi/4, J = pi/32, so 1/A = 4/pi, 2r/J = 32/pi, r/J = 16/pi.
  const SectionStress s = section_stress({3, -2, -5, 7}, 0.5);
  EXPECT_NEAR(s.sigma, (3 * 4 + 7 * 32) / pi, 1e-13);
  EXPECT_NEAR(s.tau, (2 * 4 + 5 * 16) / pi, 1e-13);
}

TEST(SectionStress, IsNegativeInPureCompression) {
  const SectionStress s = section_stress({-3, 0, 0, 0}, 0.5);
  EXPECT_NEAR(s.sigma, -12 / pi, 1e-14);
  EXPECT_NEAR(s.tau, 0, 1e-14);
}

TEST(SectionStress, EqualsBeamTheoryMROverI) {
  const double r = 0.02, i = pi * std::pow(r, 4) / 4;
  EXPECT_NEAR(section_stress({0, 0, 0, 11}, r).sigma, 11 * r / i, 1e-13 * 11 * r / i);
}

TEST(SectionStress, IsUnknownWithoutASection) {
  EXPECT_TRUE(std::isnan(section_stress({1, 1, 1, 1}, not_given).sigma));
  EXPECT_TRUE(std::isnan(section_stress({1, 1, 1, 1}, 0).tau));
}

}  // namespace
}  // namespace bondstatic
