#include "io/number_field.hpp"

#include <charconv>
#include <limits>

namespace bondstatic {
namespace {

/// from_chars knows no +.
bool drop_plus(std::string_view& field) {
  if (!field.starts_with('+')) return true;
  field.remove_prefix(1);
  return !field.starts_with('-');
}

std::optional<double> parsed(std::string_view field) {
  const bool one_sign = drop_plus(field);
  const char* end = field.data() + field.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (stop != end || field.empty() || !one_sign) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace

double number_field(std::string_view field) {
  return parsed(field).value_or(std::numeric_limits<double>::quiet_NaN());
}

bool is_number_field(std::string_view field) {
  return parsed(field).has_value();
}

std::optional<Index> whole_number_field(std::string_view field) {
  const bool one_sign = drop_plus(field);
  const char* end = field.data() + field.size();
  Index value = 0;
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (stop != end || field.empty() || !one_sign || error != std::errc()) return std::nullopt;
  return value;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && blank(line[at])) ++at;
    if (at == line.size() || line[at] == '#') return;
    std::size_t end = at;
    while (end < line.size() && !blank(line[end])) ++end;
    fields.push_back(line.substr(at, end - at));
    at = end;
  }
}

}  // namespace bondstatic
