#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t {
  normal_stiffness,
  shear_stiffness,
  effective_modulus,
  stiffness_ratio,
  radius,
  radius_factor
};

constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const RoundSection<T> section{bond_radius(site, in[radius], in[radius_factor])};
  T normal = in[normal_stiffness], shear = in[shear_stiffness];
  if (std::isnan(double(normal))) {
    // Deformability form: PFC takes the sum of the radii for the length, whatever the gap.
    normal = in[effective_modulus] / (site.radius_a + site.radius_b);
    shear = normal / in[stiffness_ratio];
  }
  return {.kn = normal * section.area(),
          .ks = shear * section.area(),
          .kt = shear * section.polar_moment(),
          .kb = normal * section.second_moment(),
          .radius = section.radius};
};

}  // namespace

BondLaw pfc_parallel_law() {
  return {
      .name = "pfc-parallel",
      .title = "linear parallel bond with PFC's own inputs (pb_kn, pb_ks or deformability method)",
      .source = "Itasca PFC, linear parallel bond model; Potyondy & Cundall 2004; [Chen2022] section 2.1",
      .formulas = {"kn = pb_kn A", "ks = pb_ks A", "kt = pb_ks J", "kb = pb_kn I",
                   "deformability: pb_kn = E* / (Ra + Rb), pb_ks = pb_kn / kappa*"},
      .parameters = {optional_input(required_input("normal_stiffness", dimension::stress_per_length,
                                                   "pb_kn: normal stiffness per unit area")),
                     optional_input(required_input("shear_stiffness", dimension::stress_per_length,
                                                   "pb_ks: shear stiffness per unit area")),
                     optional_input(required_input("effective_modulus", dimension::stress,
                                                   "E* of the deformability method (pb_deform emod)")),
                     optional_input(required_input("stiffness_ratio", dimension::none,
                                                   "kappa* = pb_kn/pb_ks (pb_deform kratio)")),
                     radius_input(), radius_factor_input()},
      .alternatives = {{{"normal_stiffness", "shear_stiffness"}, {"effective_modulus", "stiffness_ratio"}},
                       radius_ways()},
      .contact_point = {ContactPoint::Kind::gap},
      .remark = "radius_factor is PFC's radius multiplier (pb_rmul).",
      .evaluate = value_of(formula),
      .differentiate = derivative_of(formula),
  };
}

}  // namespace bondstatic
