#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { young, poisson, radius_factor };

/// Flexibility of a Timoshenko cantilever at its free end: w = shear F + coupling M, slope = coupling F +
/// bending M.
template <class T>
struct Flexibility {
  T axial, twist, shear, coupling, bending;
};

template <class T>
Flexibility<T> cantilever(double length, const RoundSection<T>& section, const T& e, const T& g) {
  const T ei = e * section.second_moment(), ga = g * section.area();
  return {.axial = length / (e * section.area()),
          .twist = length / (g * section.polar_moment()),
          .shear = length * length * length / (3 * ei) + round_form_factor * length / ga,
          .coupling = length * length / (2 * ei),
          .bending = length / ei};
}

constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const RoundSection<T> section_a{in[radius_factor] * site.radius_a},
      section_b{in[radius_factor] * site.radius_b};
  const T g = shear_modulus(in[young], in[poisson]);
  const double sum = site.radius_a + site.radius_b;
  // Both ends by the same expression, so that swapping them changes not even the rounding.
  const Flexibility<T> a = cantilever(site.length * (site.radius_a / sum), section_a, in[young], g);
  const Flexibility<T> b = cantilever(site.length * (site.radius_b / sum), section_b, in[young], g);
  // Segment b hangs on the other end: seen along e_x its coupling has the opposite sign.
  const T shear = a.shear + b.shear, bending = a.bending + b.bending, coupling = a.coupling - b.coupling;
  const T determinant = shear * bending - coupling * coupling;  // >= shear bending / 4, so no cancellation
  return {.kn = 1 / (a.axial + b.axial),
          .ks = bending / determinant,
          .kt = 1 / (a.twist + b.twist),
          .kb = shear / determinant,
          .coupling = -coupling / determinant,
          .radius = std::min(section_a.radius, section_b.radius)};
};

}  // namespace

BondLaw two_segment_law() {
  Parameter factor = radius_factor_input();
  factor.meaning = "radius of each segment over the radius of its particle";
  return {
      .name = "two-segment",
      .title = "two segments in series, lengths and radii as the particles (after Rojek)",
      .source =
          "[Chen2022] section 2.1 names it (Rojek et al. 2012); derived here: flexibilities of two "
          "Timoshenko segments added and inverted",
      .formulas = {"a = L Ra / (Ra + Rb), b = L - a, ra = factor Ra, rb = factor Rb",
                   "1/kn = a / E Aa + b / E Ab", "1/kt = a / G Ja + b / G Jb",
                   "f11 = a^3 / 3 E Ia + 10 a / 9 G Aa + b^3 / 3 E Ib + 10 b / 9 G Ab",
                   "f12 = a^2 / 2 E Ia - b^2 / 2 E Ib", "f22 = a / E Ia + b / E Ib",
                   "ks = f22 / D, kb = f11 / D, c = -f12 / D, D = f11 f22 - f12^2"},
      .parameters = {young_input(), poisson_input(), factor},
      .contact_point = {ContactPoint::Kind::section_change},
      .remark =
          "Derived here: the published prefactor is not known to this program, so radius_factor is an "
          "input. C couples shear and bending and belongs to the change of section; at another contact "
          "point it is transformed, so that the bond stays the same and only its moments are reported "
          "elsewhere. Stresses are those of the thinner segment. Equal radii give timoshenko.",
      .stiffness_at_own_contact_point = true,
      .evaluate = value_of(formula),
      .differentiate = derivative_of(formula),
  };
}

}  // namespace bondstatic
