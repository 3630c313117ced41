// A law's formula, and the two functions that a law makes of it. A formula is a lambda over the scalar type,
//
//     constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
//     .. };
//
// so that the value and the derivative can never disagree.
#pragma once

#include "bond/laws/dual.hpp"
#include "bondstatic/bond_law.hpp"

namespace bondstatic {

/// What a formula says of a bond, as BondProperties does.
template <class T>
struct FormulaValue {
  T kn = 0, ks = 0, kt = 0, kb = 0, coupling = 0;
  T radius = not_given;
  bool moments_fed_back = true;
};

/// BondLaw::evaluate
template <class Formula>
auto value_of(Formula formula) {
  return [formula](const BondSite& site, std::span<const double> in) {
    const FormulaValue<double> c = formula(site, in);
    return BondProperties{.stiffness = {c.kn, c.ks, c.kt, c.kb, c.coupling},
                          .radius = c.radius,
                          .moments_fed_back = c.moments_fed_back};
  };
}

/// BondLaw::differentiate
template <class Formula>
auto derivative_of(Formula formula) {
  return [formula](const BondSite& site, std::span<const double> in, std::size_t parameter) {
    std::vector<Dual> numbers(in.begin(), in.end());
    numbers.at(parameter).slope = 1;
    const FormulaValue<Dual> c = formula(site, std::span<const Dual>(numbers));
    return BondDerivative{{c.kn.slope, c.ks.slope, c.kt.slope, c.kb.slope, c.coupling.slope}, c.radius.slope};
  };
}

}  // namespace bondstatic
