#include "case/output_dimension.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace bondstatic {

std::optional<Dimension> dimension_of_output(const std::string& of) {
  using Names = std::vector<const char*>;
  static const std::vector<std::pair<Dimension, Names>> whole{
      {dimension::length, {"x", "y", "z", "radius", "ux", "uy", "uz", "u"}},
      {dimension::none,
       {"rx", "ry", "rz", "rotation", "apparent_poisson", "effective_poisson", "effective_misfit"}},
      {dimension::force, {"fx", "fy", "fz", "normal_force", "shear_force"}},
      {dimension::moment, {"mx", "my", "mz", "twisting_moment", "bending_moment", "energy", "work"}},
      {dimension::stress, {"sigma", "tau", "apparent_young", "effective_young"}}};
  static const std::vector<std::pair<Dimension, Names>> begins{
      {dimension::force, {"reaction_f"}},
      {dimension::moment, {"reaction_m"}},
      {dimension::stress, {"stress_", "effective_c"}}};
  for (const auto& [dimension, names] : whole)
    for (const char* name : names)
      if (of == name) return dimension;
  for (const auto& [dimension, names] : begins)
    for (const char* name : names)
      if (of.starts_with(name)) return dimension;
  return std::nullopt;
}

std::optional<double> unit_scale(double scale) {
  const double size = std::abs(scale);
  const double power = std::pow(10.0, std::round(std::log10(size)));
  if (size > 0 && std::abs(size - power) <= 1e-12 * power) return size;
  return std::nullopt;
}

}  // namespace bondstatic
