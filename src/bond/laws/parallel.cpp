#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { young, poisson, kappa, radius, radius_factor };

constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const T r = bond_radius(site, in[radius], in[radius_factor]);
  const T ratio = std::isnan(double(in[kappa])) ? 2 * (1 + in[poisson]) : in[kappa];
  const T kn = in[young] * RoundSection<T>{r}.area() / site.length;
  const T ks = kn / ratio;
  return {.kn = kn, .ks = ks, .kt = 0.5 * ks * r * r, .kb = 0.25 * kn * r * r, .radius = r};
};

}  // namespace

BondLaw parallel_law() {
  return {
      .name = "parallel",
      .title = "parallel bond model, PBM (Potyondy & Cundall; Brendel's ratio from poisson)",
      .source = "[Chen2022] Table 1, 9, Eq. 8",
      .formulas = {"kn = E A / L", "ks = kn / kappa, kappa given or 2 (1 + nu)", "kt = ks r^2 / 2",
                   "kb = kn r^2 / 4"},
      .parameters = {young_input(), optional_input(poisson_input()),
                     optional_input(required_input("kappa", dimension::none, "ratio kn/ks")), radius_input(),
                     radius_factor_input()},
      .alternatives = {{{"poisson"}, {"kappa"}}, radius_ways()},
      .contact_point = {ContactPoint::Kind::gap},
      .remark =
          "Springs spread over the section: ks does not fall with the bond's length, so slender bonds are "
          "too stiff in bending.",
      .evaluate = value_of(formula),
      .differentiate = derivative_of(formula),
  };
}

}  // namespace bondstatic
