#include <fmt/format.h>

#include <array>
#include <numbers>

#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"
#include "bond/laws/tanh_sinh.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { young, poisson, radius, radius_factor };

/// Sphere cap above a disk of radius rho, R - sqrt(R^2 - rho^2), without cancellation; `rest` = R^2 - rho^2.
double cap(double sphere_radius, double rho_squared, double rest) {
  return rho_squared / (sphere_radius + std::sqrt(rest));
}

/// Length of the fibre at rho, with rho^2 = `square` and r^2 - rho^2 = `missing`.
double fibre_length(const BondSite& site, double r, double square, double missing) {
  const double ra = site.radius_a, rb = site.radius_b;
  const double rest_a = (ra - r) * (ra + r), rest_b = (rb - r) * (rb + r);
  return site.gap() + cap(ra, square, rest_a + missing) + cap(rb, square, rest_b + missing);
}

/// Integrals of rho / l and rho^3 / l from 0 to r, with l the length of the fibre at rho.
std::array<double, 2> fibre_integrals(const BondSite& site, double r) {
  const Eigen::Vector2d integral = integrate_unit_interval([&](double x, double complement) {
    // x = rho^2 / r^2: 2 rho drho = r^2 dx, and the integrand's peak at rho = 0 becomes one at an end.
    const double fibre = fibre_length(site, r, r * r * x, r * r * complement);
    return Eigen::Vector2d(1 / fibre, x / fibre);
  });
  return {0.5 * r * r * integral[0], 0.5 * r * r * (r * r * integral[1])};
}

/// They change with their upper limit as their integrand at it.
std::array<Dual, 2> fibre_integrals(const BondSite& site, const Dual& upper) {
  const double r = upper.value;
  const auto [first, third] = fibre_integrals(site, r);
  const double slope = upper.slope * r / fibre_length(site, r, r * r, 0);
  return {Dual(first, slope), Dual(third, r * r * slope)};
}

constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  using std::numbers::pi;
  const T r = bond_radius(site, in[radius], in[radius_factor]);
  const T e = in[young], g = shear_modulus(e, in[poisson]);
  const auto [first, third] = fibre_integrals(site, r);
  return {.kn = 2 * pi * e * first,
          .ks = 2 * pi * g * first,
          .kt = 2 * pi * g * third,
          .kb = pi * e * third,
          .radius = r};
};

std::string forbids(const BondSite& site, std::span<const double> in) {
  if (!(site.gap() > 0))
    return fmt::format("gap = {} must be positive; bond touching particles with another law, e.g. timoshenko",
                       site.gap());
  const double r = bond_radius(site, in[radius], in[radius_factor]);
  const double smaller = std::min(site.radius_a, site.radius_b);
  if (r > smaller)
    return fmt::format(
        "bond radius {} must not exceed the smaller particle radius {}; give radius_factor, at most 1", r,
        smaller);
  return {};
}

}  // namespace

BondLaw concave_end_law() {
  return {
      .name = "concave-end",
      .title = "cylinder with concave ends that fits between the spheres (after Shen)",
      .source =
          "[Chen2022] section 2.1 names it (Shen et al. 2016); derived here: parallel fibres from sphere "
          "to sphere",
      .formulas = {"l(rho) = gap + Ra - sqrt(Ra^2 - rho^2) + Rb - sqrt(Rb^2 - rho^2)",
                   "kn = integral of 2 pi E rho / l, rho from 0 to r", "ks = integral of 2 pi G rho / l",
                   "kt = integral of 2 pi G rho^3 / l", "kb = integral of pi E rho^3 / l"},
      .parameters = {young_input(), poisson_input(), radius_input(), radius_factor_input()},
      .alternatives = {radius_ways()},
      .contact_point = {ContactPoint::Kind::gap},
      .remark =
          "Derived here: independent fibres between rigid spheres. Needs a gap > 0 and r <= min(Ra, Rb).",
      .evaluate = value_of(formula),
      .differentiate = derivative_of(formula),
      .forbids = forbids,
  };
}

}  // namespace bondstatic
