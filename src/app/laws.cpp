#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/parameter_listing.hpp"

namespace bondstatic {

namespace {

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
  std::string text = fmt::format("{}  {}\n", bold(law.name, stdout), law.title);
  for (const std::string& formula : law.formulas) text += fmt::format("    {}\n", formula);
  text += fmt::format("  parameters\n{}", to_text(table_of(law.parameters), 4));
  for (const Alternatives& alternatives : law.alternatives)
    text += fmt::format("    {}\n", alternatives_text(alternatives));
  text += fmt::format("  contact point  {}\n", contact_point_text(law.contact_point));
  text += fmt::format("  source         {}\n", wrapped(law.source, 17));
  if (!law.remark.empty()) text += fmt::format("  remark         {}\n", wrapped(law.remark, 17));
  return text;
}

Json json_of(const BondLaw& law) {
  return {{"name", law.name},
          {"title", law.title},
          {"formulas", law.formulas},
          {"parameters", json_of(law.parameters)},
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
  if (text.empty() && listed.empty()) throw unknown_name("law", name, names);
  fmt::print("{}", json ? listed.dump(2) + "\n" : text);
  return ExitCode::done;
}

}  // namespace bondstatic
