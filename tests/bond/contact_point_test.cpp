#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using Kind = ContactPoint::Kind;

double distance(ContactPoint point, const std::string& law, const BondSite& here) {
  return contact_fraction(point, *find_bond_law(law), here) * here.length;
}

const BondSite pair = site(0.8, 0.4, 0.3);  // gap 0.1

TEST(ContactPointChoice, IsMeasuredFromParticleA) {
  EXPECT_NEAR(distance({Kind::gap, 0}, "timoshenko", pair), 0.45, 1e-16);
  EXPECT_NEAR(distance({Kind::beam, 0}, "parallel", pair), 0.4, 1e-16);
  EXPECT_NEAR(distance({Kind::fraction, 0.25}, "parallel", pair), 0.2, 1e-16);
  EXPECT_NEAR(distance({Kind::contact_radii, 1.1}, "parallel", pair), 0.455, 1e-16);
  EXPECT_NEAR(distance({Kind::section_change, 0}, "parallel", pair), 0.8 * 4 / 7, 1.2e-16);
}

TEST(ContactPointChoice, OfTheLawIsTheGapForSpringsAndTheMiddleForBeams) {
  for (const char* law : {"parallel", "pfc-parallel", "edem-v2", "contact", "concave-end"})
    EXPECT_NEAR(distance({}, law, pair), 0.45, 1e-16) << law;
  for (const char* law : {"euler-bernoulli", "timoshenko", "obermayr", "generic"})
    EXPECT_NEAR(distance({}, law, pair), 0.4, 1e-16) << law;
  EXPECT_NEAR(distance({}, "two-segment", pair), 0.8 * 4 / 7, 1.2e-16);
}

TEST(ContactPointChoice, IsExactlyTheMiddleForEqualRadii) {
  for (const BondLaw& law : bond_laws())
    EXPECT_EQ(contact_fraction({}, law, site(0.7, 0.3, 0.3)), 0.5) << law.name;
}

TEST(ContactPointChoice, LiesInTheOverlapOfOverlappingParticles) {
  EXPECT_NEAR(distance({Kind::gap, 0}, "parallel", site(0.6, 0.4, 0.3)), 0.35, 1e-16);  // between 0.3 and 0.4
}

}  // namespace
}  // namespace bondstatic
