#include "bondstatic/sensitivity.hpp"

#include "system/extended.hpp"

namespace bondstatic {
namespace {

/// dJ/dp of the i-th of the parameter's bonds. Its terms can cancel, as do those of many bonds.
Extended of_bond(const BondGradients& gradient, const ParameterDerivative& parameter, std::size_t i) {
  const BondGradient& dj = gradient.at(std::size_t(parameter.bonds[i]));
  const BondDerivative& dp = parameter.of_bond[i];
  const SectionStiffness &j = dj.stiffness, &c = dp.stiffness;
  Extended sum = 0.0;
  for (const auto& [x, y] :
       {std::pair(j.kn, c.kn), std::pair(j.ks, c.ks), std::pair(j.kt, c.kt), std::pair(j.kb, c.kb),
        std::pair(j.coupling, c.coupling), std::pair(dj.radius, dp.radius)})
    if (y != 0) sum += Extended(x) * y;  // most laws' parameters leave some numbers alone
  return sum;
}

}  // namespace

double derivative(const BondGradients& gradient, const ParameterDerivative& parameter) {
  Extended sum = 0.0;
  for (std::size_t i = 0; i < parameter.bonds.size(); ++i)
    if (!parameter.has_own[i]) sum += of_bond(gradient, parameter, i);
  return to_double(sum);
}

std::vector<double> derivative_by_bond(const BondGradients& gradient, const ParameterDerivative& parameter) {
  std::vector<double> out;
  for (std::size_t i = 0; i < parameter.bonds.size(); ++i)
    out.push_back(to_double(of_bond(gradient, parameter, i)));
  return out;
}

}  // namespace bondstatic
