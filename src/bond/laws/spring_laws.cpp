// Laws whose stiffness is given as such.
#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"

namespace bondstatic {
namespace {

constexpr auto contact = []<class T>(const BondSite&, std::span<const T> in) -> FormulaValue<T> {
  return {.kn = in[0], .ks = in[1], .radius = in[2]};
};

constexpr auto generic = []<class T>(const BondSite&, std::span<const T> in) -> FormulaValue<T> {
  return {.kn = in[0], .ks = in[1], .kt = in[2], .kb = in[3], .radius = in[4]};
};

Parameter normal_spring() {
  return required_input("kn", dimension::stiffness, "normal stiffness");
}
Parameter shear_spring() {
  return required_input("ks", dimension::stiffness, "shear stiffness", true);
}

}  // namespace

BondLaw contact_law() {
  return {
      .name = "contact",
      .title = "contact bond (\"pin\", linear contact bond): point glue without moments",
      .source = "[Chen2022] section 1; Itasca PFC, linear contact bond model",
      .formulas = {"kn, ks as given", "kt = kb = 0"},
      .parameters = {normal_spring(), shear_spring(), stress_radius_input()},
      .contact_point = {ContactPoint::Kind::gap},
      .remark = "Carries no moment: packings held by it may be mechanisms.",
      .evaluate = value_of(contact),
      .differentiate = derivative_of(contact),
  };
}

BondLaw generic_law() {
  return {
      .name = "generic",
      .title = "generic bond: four stiffnesses at a contact point of choice",
      .source = "[Chen2022] Table 8",
      .formulas = {"kn, ks, kt, kb as given"},
      .parameters = {normal_spring(), shear_spring(),
                     required_input("kt", dimension::rotational_stiffness, "twisting stiffness", true),
                     required_input("kb", dimension::rotational_stiffness, "bending stiffness", true),
                     stress_radius_input()},
      .contact_point = {ContactPoint::Kind::beam},
      .remark = "Every law with diagonal C is this one with its own formulas.",
      .evaluate = value_of(generic),
      .differentiate = derivative_of(generic),
  };
}

}  // namespace bondstatic
