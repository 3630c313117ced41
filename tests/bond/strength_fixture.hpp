// Strength criteria to test with: by name, typical strengths of each, random resultants.
#pragma once

#include "bond/bond_fixture.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

inline std::vector<double> strengths_in_order(const StrengthCriterion& criterion, const Inputs& inputs) {
  std::vector<double> values(criterion.parameters.size(), not_given);
  for (const auto& [name, value] : inputs) values.at(std::size_t(criterion.find(name))) = value;
  return values;
}

inline std::vector<std::string> strength_complaints(const std::string& name, const Inputs& inputs) {
  const StrengthCriterion& criterion = *find_strength_criterion(name);
  std::vector<std::string> out;
  complete_strengths(criterion, strengths_in_order(criterion, inputs), out);
  return out;
}

inline std::vector<FailureMode> failure_modes(const std::string& name, const Inputs& inputs,
                                              const BondSection& section) {
  const StrengthCriterion& criterion = *find_strength_criterion(name);
  std::vector<std::string> found;
  const std::vector<double> values =
      complete_strengths(criterion, strengths_in_order(criterion, inputs), found);
  if (!found.empty()) throw std::invalid_argument(found.front());
  std::vector<FailureMode> modes;
  criterion.failure_modes(section, values, modes);
  return modes;
}

/// Every criterion with strengths that resultants of about 1 come near, in sections of radius about 0.5.
inline std::map<std::string, Inputs> typical_strengths() {
  return {{"edem-v2", {{"critical_normal_stress", 5}, {"critical_shear_stress", 3}}},
          {"pfc-parallel",
           {{"tensile_strength", 5}, {"cohesion", 4}, {"friction_angle", 0.6}, {"moment_contribution", 0.7}}},
          {"brown", {{"compressive_strength", 30}, {"tensile_strength", 5}, {"shear_strength", 3}}},
          {"musen", {{"normal_strength", 5}, {"tangential_strength", 3}}},
          {"bpm-rotational",
           {{"critical_normal_force", 4},
            {"critical_shear_force", 3},
            {"critical_twisting_moment", 2},
            {"critical_bending_moment", 5}}},
          {"contact-bond", {{"critical_tensile_force", 2}, {"critical_shear_force", 3}}}};
}

class RandomResultants : public RandomBonds {
 public:
  SectionVector resultants(double scale = 1) {
    const auto number = [&] { return scale * uniform(-1, 1); };
    return {number(), number(), {number(), number()}, {number(), number()}};
  }

  BondSection section() { return {uniform(0.3, 0.8), uniform(0.5, 3), uniform(0.2, 0.8)}; }
};

inline double utilisation_of(std::span<const FailureMode> modes, const BondSection& section,
                             const SectionVector& carried) {
  return utilisation(modes, section.length, section.fraction, carried).value;
}

}  // namespace bondstatic
