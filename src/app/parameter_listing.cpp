#include "app/parameter_listing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

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

Json bound(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace

TextTable table_of(const std::vector<Parameter>& parameters) {
  TextTable table;
  for (const Parameter& parameter : parameters) {
    const std::string unit = si_unit(parameter.dimension);
    table.rows.push_back({parameter.name, unit.empty() ? "-" : unit, bounds_text(parameter),
                          default_text(parameter), parameter.meaning});
  }
  return table;
}

Json json_of(const std::vector<Parameter>& parameters) {
  Json list = Json::array();
  for (const Parameter& parameter : parameters) {
    const char* kind = parameter.truth ? "boolean" : parameter.whole ? "integer" : "number";
    list.push_back({{"name", parameter.name},
                    {"type", kind},
                    {"unit", si_unit(parameter.dimension)},
                    {"lower", bound(parameter.lower)},
                    {"lower_included", parameter.lower_included},
                    {"upper", bound(parameter.upper)},
                    {"default", bound(parameter.default_value)},
                    {"optional", parameter.optional},
                    {"meaning", parameter.meaning}});
  }
  return list;
}

Error unknown_name(const std::string& kind, const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return Error(
      ExitCode::invalid_input,
      fmt::format("unknown {} \"{}\"{}\n    cure: choose one of {}", kind, name,
                  nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest), name_list(known)));
}

}  // namespace bondstatic
