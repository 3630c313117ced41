#include "bond/laws/inputs.hpp"

#include <utility>

namespace bondstatic {

Parameter required_input(std::string name, Dimension dimension, std::string meaning, bool zero_allowed) {
  Parameter input;
  input.name = std::move(name);
  input.dimension = dimension;
  input.meaning = std::move(meaning);
  input.lower_included = zero_allowed;
  return input;
}

Parameter optional_input(Parameter input) {
  input.optional = true;
  return input;
}

Parameter young_input() {
  return required_input("young", dimension::stress, "Young's modulus E of the bond material");
}

Parameter poisson_input() {
  Parameter input = required_input("poisson", dimension::none, "Poisson's ratio nu of the bond material");
  input.lower = -1;
  input.upper = 0.5;
  return input;
}

Parameter radius_input() {
  return optional_input(required_input("radius", dimension::length, "radius r of the bond"));
}

Parameter radius_factor_input() {
  Parameter input =
      required_input("radius_factor", dimension::none, "bond radius r over the smaller particle radius");
  input.default_value = 1;
  return input;
}

Parameter stress_radius_input() {
  return optional_input(
      required_input("radius", dimension::length, "radius r of the section, for stresses only"));
}

Alternatives radius_ways() {
  return {{"radius"}, {"radius_factor"}};
}

}  // namespace bondstatic
