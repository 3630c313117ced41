// Beams from centre to centre: they differ in the shear stiffness alone.
#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { young, poisson, radius, radius_factor, shear_coefficient };

template <class T>
RoundSection<T> section_of(const BondSite& site, std::span<const T> in) {
  return {bond_radius(site, in[radius], in[radius_factor])};
}

template <class T>
FormulaValue<T> beam(const BondSite& site, std::span<const T> in, const T& ks) {
  const RoundSection<T> section = section_of(site, in);
  const T kn = in[young] * section.area() / site.length;
  const T kb = in[young] * section.second_moment() / site.length;
  return {.kn = kn, .ks = ks, .kt = kb / (1 + in[poisson]), .kb = kb, .radius = section.radius};
}

/// [Chen2022] Eq. 26
template <class T>
T euler_bernoulli_shear(const BondSite& site, std::span<const T> in) {
  return 12 * in[young] * section_of(site, in).second_moment() / (site.length * site.length * site.length);
}

constexpr auto euler_bernoulli = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  return beam(site, in, euler_bernoulli_shear(site, in));
};

constexpr auto timoshenko = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const T slenderness = section_of(site, in).radius / site.length;
  const T phi = 20 * slenderness * slenderness * (1 + in[poisson]) / 3;  // [Chen2022] Eq. 25
  return beam(site, in, euler_bernoulli_shear(site, in) / (1 + phi));
};

constexpr auto obermayr = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const T g = shear_modulus(in[young], in[poisson]);
  return beam(site, in, in[shear_coefficient] * g * section_of(site, in).area() / site.length);
};

std::vector<Parameter> beam_inputs() {
  return {young_input(), poisson_input(), radius_input(), radius_factor_input()};
}

}  // namespace

BondLaw euler_bernoulli_law() {
  return {
      .name = "euler-bernoulli",
      .title = "Euler-Bernoulli beam bond model, EBBM (André)",
      .source = "[Chen2022] Eq. 26, Table 9",
      .formulas = {"kn = E A / L", "ks = 12 E I / L^3", "kt = kn r^2 / (4 (1 + nu)) = G J / L",
                   "kb = kn r^2 / 4 = E I / L"},
      .parameters = beam_inputs(),
      .alternatives = {radius_ways()},
      .contact_point = {ContactPoint::Kind::beam},
      .remark = "No shear deformation: right for slender beams.",
      .evaluate = value_of(euler_bernoulli),
      .differentiate = derivative_of(euler_bernoulli),
  };
}

BondLaw timoshenko_law() {
  return {
      .name = "timoshenko",
      .title = "Timoshenko beam bond model, TBBM (Brown)",
      .source = "[Chen2022] Eq. 14-25, Table 6, 9",
      .formulas = {"kn = E A / L", "ks = 12 E I / (L^3 (1 + Phi)), Phi = 20 r^2 (1 + nu) / (3 L^2)",
                   "kt = kn r^2 / (4 (1 + nu)) = G J / L", "kb = kn r^2 / 4 = E I / L"},
      .parameters = beam_inputs(),
      .alternatives = {radius_ways()},
      .contact_point = {ContactPoint::Kind::beam},
      .remark = "Exact for end loads on a prismatic beam, whatever the number of bonds.",
      .evaluate = value_of(timoshenko),
      .differentiate = derivative_of(timoshenko),
  };
}

BondLaw obermayr_law() {
  std::vector<Parameter> inputs = beam_inputs();
  inputs.push_back(required_input("shear_coefficient", dimension::none, "shear coefficient lambda_s"));
  inputs.back().default_value = 0.9;
  return {
      .name = "obermayr",
      .title = "beam bond model of Obermayr (Timoshenko element with reduced integration)",
      .source = "[Chen2022] Eq. 45; Obermayr et al. 2013",
      .formulas = {"kn = E A / L", "ks = lambda_s G A / L, G = E / (2 (1 + nu))", "kt = G J / L",
                   "kb = E I / L"},
      .parameters = inputs,
      .alternatives = {radius_ways()},
      .contact_point = {ContactPoint::Kind::beam},
      .remark = "lambda_s is 0.9 for a circle. Converges to Timoshenko's beam with the number of bonds.",
      .evaluate = value_of(obermayr),
      .differentiate = derivative_of(obermayr),
  };
}

}  // namespace bondstatic
