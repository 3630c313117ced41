// Bonds to test with: a law by name, typical inputs of every law, random sites and axes.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

using Inputs = std::map<std::string, double>;

inline std::vector<double> in_order(const BondLaw& law, const Inputs& inputs) {
  std::vector<double> values(law.parameters.size(), not_given);
  for (const auto& [name, value] : inputs) values.at(std::size_t(law.find(name))) = value;
  return values;
}

inline std::vector<std::string> complaints(const std::string& name, const Inputs& inputs) {
  const BondLaw& law = *find_bond_law(name);
  std::vector<std::string> out;
  complete_parameters(law, in_order(law, inputs), out);
  return out;
}

/// C and the contact point, with everything that bond_properties() checks left out.
inline BondProperties evaluate(const std::string& name, const Inputs& inputs, const BondSite& site) {
  const BondLaw& law = *find_bond_law(name);
  std::vector<std::string> found;
  const std::vector<double> values = complete_parameters(law, in_order(law, inputs), found);
  if (!found.empty()) throw std::invalid_argument(found.front());
  BondProperties out = law.evaluate(site, values);
  out.fraction = contact_fraction({}, law, site);
  return out;
}

inline BondSite site(double length, double radius_a, double radius_b) {
  return {length, radius_a, radius_b, 1, 2};
}

/// Every law with inputs that suit particles of about 0.1 to 0.2 with a gap between them.
inline std::map<std::string, Inputs> typical_inputs() {
  const Inputs beam{{"young", 7e10}, {"poisson", 0.2}, {"radius", 0.08}};
  return {
      {"parallel", {{"young", 7e10}, {"kappa", 2.5}}},
      {"pfc-parallel", {{"effective_modulus", 3e9}, {"stiffness_ratio", 1.5}, {"radius_factor", 0.7}}},
      {"euler-bernoulli", beam},
      {"timoshenko", beam},
      {"obermayr", beam},
      {"edem-v2",
       {{"normal_stiffness", 1e10}, {"shear_stiffness", 4e9}, {"normal_range", 3e9}, {"torque_feedback", 1}}},
      {"contact", {{"kn", 1e8}, {"ks", 3e7}}},
      {"two-segment", {{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.6}}},
      {"concave-end", beam},
      {"generic", {{"kn", 1e8}, {"ks", 3e7}, {"kt", 2e5}, {"kb", 4e5}}}};
}

class RandomBonds {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  Vector3 direction() {
    std::normal_distribution<double> normal;
    return Vector3(normal(engine_), normal(engine_), normal(engine_)).normalized();
  }

  BondSite gapped_site() {
    const double a = uniform(0.1, 0.2), b = uniform(0.1, 0.2);
    return site((a + b) * uniform(1.05, 1.5), a, b);
  }

 private:
  std::mt19937_64 engine_{20240229};
};

inline Link link(const BondProperties& properties, const Vector3& branch) {
  Link out;
  out.a = 0;
  out.b = 1;
  out.branch = branch;
  out.fraction = properties.fraction;
  out.stiffness = properties.stiffness;
  return out;
}

/// Largest |x - y| over the natural size of the entry, sqrt(y_ii y_jj): the same in any unit system.
template <class MatrixX, class MatrixY>
double scaled_difference(const MatrixX& x, const MatrixY& y) {
  double worst = 0;
  for (int i = 0; i < y.rows(); ++i)
    for (int j = 0; j < y.cols(); ++j)
      worst = std::max(worst, double(std::abs((x(i, j) - y(i, j)) / std::sqrt(y(i, i) * y(j, j)))));
  return worst;
}

}  // namespace bondstatic
