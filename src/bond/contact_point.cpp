#include "bond/contact_point.hpp"

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

SectionStiffness moved(const SectionStiffness& stiffness, double distance) {
  SectionStiffness out = stiffness;
  out.coupling = stiffness.coupling - distance * stiffness.ks;
  out.kb = stiffness.kb - distance * (stiffness.coupling + out.coupling);
  return out;
}

double contact_fraction(ContactPoint choice, const BondLaw& law, const BondSite& site) {
  const ContactPoint point = choice.kind == ContactPoint::Kind::of_law ? law.contact_point : choice;
  const double difference = site.radius_a - site.radius_b;
  switch (point.kind) {
    case ContactPoint::Kind::gap:
      return 0.5 * (1 + difference / site.length);
    case ContactPoint::Kind::contact_radii:
      return 0.5 * (1 + point.value * difference / site.length);
    case ContactPoint::Kind::fraction:
      return point.value;
    case ContactPoint::Kind::section_change:
      return site.radius_a / (site.radius_a + site.radius_b);
    case ContactPoint::Kind::beam:
    case ContactPoint::Kind::of_law:
      break;
  }
  return 0.5;
}

}  // namespace bondstatic
