#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/terminal.hpp"
#include "bondstatic/bond_law.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

using Json = nlohmann::ordered_json;

std::string contact_point_text(const ContactPoint& point) {
  switch (point.kind) {
    case ContactPoint::Kind::gap:
      return "centre of the gap, a = (L + Ra - Rb)/2";
    case ContactPoint::Kind::beam:
      return "middle of the bond, a = L/2";
    case ContactPoint::Kind::fraction:
      return fmt::format("a = {:g} L", point.value);
    case ContactPoint::Kind::contact_radii:
      return fmt::format("centre of the gap of contact radii, a = (L + {0:g} Ra - {0:g} Rb)/2", point.value);
    case ContactPoint::Kind::section_change:
      return "change of section, a = L Ra/(Ra + Rb)";
    case ContactPoint::Kind::of_law:
      break;
  }
  return "the law's own";
}

std::string bounds_text(const Parameter& parameter) {
  if (parameter.truth) return "true or false";
  const bool below = std::isfinite(parameter.lower), above = std::isfinite(parameter.upper);
  std::string text;
  if (below && above)
    text = fmt::format("in {}{:g}, {:g}]", parameter.lower_included ? "[" : "(", parameter.lower,
                       parameter.upper);
  else if (below)
    text = fmt::format("{} {:g}", parameter.lower_included ? ">=" : ">", parameter.lower);
  else if (above)
    text = fmt::format("<= {:g}", parameter.upper);
  if (parameter.whole) text += text.empty() ? "whole" : ", whole";
  return text;
}

std::string default_text(const Parameter& parameter) {
  if (std::isnan(parameter.default_value)) return parameter.optional ? "optional" : "required";
  if (parameter.truth) return parameter.default_value != 0 ? "default true" : "default false";
  return fmt::format("default {:g}", parameter.default_value);
}

/// "poisson or kappa", "young and poisson, or kn".
std::string alternatives_text(const Alternatives& alternatives) {
  std::string text;
  for (const auto& group : alternatives) {
    if (!text.empty()) text += " or ";
    for (std::size_t i = 0; i < group.size(); ++i) text += (i == 0 ? "" : " with ") + group[i];
  }
  return "give " + text;
}

std::string text_of(const BondLaw& law) {
  TextTable parameters{{}, {}};
  for (const Parameter& parameter : law.parameters) {
    const std::string unit = si_unit(parameter.dimension);
    parameters.rows.push_back({parameter.name, unit.empty() ? "-" : unit, bounds_text(parameter),
                               default_text(parameter), parameter.meaning});
  }
  std::string text = fmt::format("{}  {}\n", bold(law.name, stdout), law.title);
  for (const std::string& formula : law.formulas) text += fmt::format("    {}\n", formula);
  text += fmt::format("  parameters\n{}", to_text(parameters, 4));
  for (const Alternatives& alternatives : law.alternatives)
    text += fmt::format("    {}\n", alternatives_text(alternatives));
  text += fmt::format("  contact point  {}\n", contact_point_text(law.contact_point));
  text += fmt::format("  source         {}\n", wrapped(law.source, 17));
  if (!law.remark.empty()) text += fmt::format("  remark         {}\n", wrapped(law.remark, 17));
  return text;
}

Json bound(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const BondLaw& law) {
  Json parameters = Json::array();
  for (const Parameter& parameter : law.parameters) {
    const char* kind = parameter.truth ? "boolean" : parameter.whole ? "integer" : "number";
    parameters.push_back({{"name", parameter.name},
                          {"type", kind},
                          {"unit", si_unit(parameter.dimension)},
                          {"lower", bound(parameter.lower)},
                          {"lower_included", parameter.lower_included},
                          {"upper", bound(parameter.upper)},
                          {"default", bound(parameter.default_value)},
                          {"optional", parameter.optional},
                          {"meaning", parameter.meaning}});
  }
  return {{"name", law.name},
          {"title", law.title},
          {"formulas", law.formulas},
          {"parameters", parameters},
          {"alternatives", law.alternatives},
          {"contact_point", contact_point_text(law.contact_point)},
          {"source", law.source},
          {"remark", law.remark}};
}

}  // namespace

ExitCode laws(const std::string& name, bool json) {
  Json listed = Json::array();
  std::string text;
  std::vector<std::string> names;
  for (const BondLaw& law : bond_laws()) {
    names.push_back(law.name);
    if (!name.empty() && law.name != name) continue;
    if (json)
      listed.push_back(json_of(law));
    else
      text += (text.empty() ? "" : "\n") + text_of(law);
  }
  if (text.empty() && listed.empty()) {
    const std::string nearest = nearest_name(name, names);
    throw Error(
        ExitCode::invalid_input,
        fmt::format("unknown law \"{}\"{}\n    cure: choose one of {}", name,
                    nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest), name_list(names)));
  }
  fmt::print("{}", json ? listed.dump(2) + "\n" : text);
  return ExitCode::done;
}

}  // namespace bondstatic
