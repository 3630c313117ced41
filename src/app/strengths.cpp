#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/parameter_listing.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

namespace {

/// Names of the parameters that may scatter.
std::vector<std::string> scattering(const StrengthCriterion& criterion) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < criterion.parameters.size(); ++p)
    if (criterion.scatters[p]) names.push_back(criterion.parameters[p].name);
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string text_of(const StrengthCriterion& criterion) {
  std::string text = fmt::format("{}  {}\n", bold(criterion.name, stdout), criterion.title);
  for (const std::string& formula : criterion.formulas) text += fmt::format("    {}\n", formula);
  text += fmt::format("  parameters\n{}", to_text(table_of(criterion.parameters), 4));
  const auto line = [&](const char* what, const std::string& said) {
    text += fmt::format("  {:<15}{}\n", what, wrapped(said, 17));
  };
  line("may scatter", joined(scattering(criterion)));
  line("modes", joined(criterion.modes));
  line("for", criterion.needs_section ? "bonds with a section" : "all bonds");
  line("source", criterion.source);
  line("remark", criterion.remark);
  return text;
}

Json json_of(const StrengthCriterion& criterion) {
  return {{"name", criterion.name},
          {"title", criterion.title},
          {"formulas", criterion.formulas},
          {"parameters", json_of(criterion.parameters)},
          {"scatters", scattering(criterion)},
          {"modes", criterion.modes},
          {"needs_section", criterion.needs_section},
          {"source", criterion.source},
          {"remark", criterion.remark}};
}

}  // namespace

ExitCode strengths(const std::string& name, bool json) {
  Json listed = Json::array();
  std::string text;
  std::vector<std::string> names;
  for (const StrengthCriterion& criterion : strength_criteria()) {
    names.push_back(criterion.name);
    if (!name.empty() && criterion.name != name) continue;
    if (json)
      listed.push_back(json_of(criterion));
    else
      text += (text.empty() ? "" : "\n") + text_of(criterion);
  }
  if (text.empty() && listed.empty()) throw unknown_name("strength criterion", name, names);
  fmt::print("{}", json ? listed.dump(2) + "\n" : text);
  return ExitCode::done;
}

}  // namespace bondstatic
