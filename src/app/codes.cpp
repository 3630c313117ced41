#include "app/codes.hpp"

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/parameter_listing.hpp"

namespace bondstatic {

namespace {

std::string text_of(const BondCode& code) {
  TextTable stored;
  for (const CodeParameter& parameter : code.stored) {
    const std::string unit = si_unit(parameter.dimension);
    stored.rows.push_back({parameter.name,
                           parameter.truth ? "true, false"
                           : unit.empty()  ? "-"
                                           : unit,
                           parameter.meaning, parameter.input});
  }
  std::string text = fmt::format("{}  {}\n", bold(code.name, stdout), code.title);
  text += fmt::format("  stores, of a bond\n{}", to_text(stored, 4));
  text += "  stiffness\n";
  for (const std::string& formula : code.formulas) text += fmt::format("    {}\n", formula);
  const auto line = [&](const char* what, const std::string& said) {
    text += fmt::format("  {:<15}{}\n", what, wrapped(said, 17));
  };
  line("contact point", fmt::format("{} ({})", code.contact_point_text, code.known_from));
  line("shear", code.shear);
  line("moments", code.moments);
  line("here", code.here);
  line("from here", code.fit);
  if (code.departure) line("beyond this", code.departure_text);
  for (const std::string& remark : code.remarks) line("mind", remark);
  line("looked at", code.version);
  line("source", code.source);
  return text;
}

Json json_of(const BondCode& code) {
  Json stored = Json::array();
  for (const CodeParameter& parameter : code.stored)
    stored.push_back({{"name", parameter.name},
                      {"type", parameter.truth ? "boolean" : "number"},
                      {"unit", si_unit(parameter.dimension)},
                      {"meaning", parameter.meaning},
                      {"input", parameter.input}});
  return {{"name", code.name},
          {"title", code.title},
          {"version", code.version},
          {"stored", stored},
          {"formulas", code.formulas},
          {"contact_point", code.contact_point_text},
          {"contact_point_known_from", code.known_from},
          {"shear", code.shear},
          {"moments", code.moments},
          {"here", code.here},
          {"fit", code.fit},
          {"departure", code.departure_text},
          {"remarks", code.remarks},
          {"source", code.source}};
}

}  // namespace

const BondCode& bond_code(const std::string& name) {
  if (const BondCode* code = find_bond_code(name)) return *code;
  std::vector<std::string> names;
  for (const BondCode& code : bond_codes()) names.push_back(code.name);
  throw unknown_name("code", name, names);
}

ExitCode codes(const std::string& name, bool json) {
  std::vector<const BondCode*> chosen;
  if (name.empty())
    for (const BondCode& code : bond_codes()) chosen.push_back(&code);
  else
    chosen.push_back(&bond_code(name));
  Json listed = Json::array();
  std::string text;
  for (const BondCode* code : chosen)
    if (json)
      listed.push_back(json_of(*code));
    else
      text += (text.empty() ? "" : "\n") + text_of(*code);
  fmt::print("{}", json ? listed.dump(2) + "\n" : text);
  return ExitCode::done;
}

}  // namespace bondstatic
