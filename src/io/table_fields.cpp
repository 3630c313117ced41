#include "io/table_fields.hpp"

#include <algorithm>

namespace bondstatic {
namespace {

constexpr std::string_view blanks = " \t\r";

std::size_t skip_blanks(std::string_view line, std::size_t at, char separator) {
  while (at < line.size() && line[at] != separator && blanks.find(line[at]) != std::string_view::npos) ++at;
  return at;
}

/// One past the closing quote of the field that opens at `at`, npos where it does not close.
std::size_t after_quotes(std::string_view line, std::size_t at) {
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') continue;
    if (at + 1 < line.size() && line[at + 1] == '"')
      ++at;
    else
      return at + 1;
  }
  return std::string_view::npos;
}

bool separates(char c, char separator) {
  return separator == ' ' ? blanks.find(c) != std::string_view::npos : c == separator;
}

/// One past the field that begins at `at`: at its separator, a comment or the end of the line.
std::size_t field_end(std::string_view line, std::size_t at, char separator) {
  if (at < line.size() && line[at] == '"') return std::min(after_quotes(line, at), line.size());
  while (at < line.size() && line[at] != '#' && !separates(line[at], separator)) ++at;
  return at;
}

}  // namespace

char separator_of(std::string_view line) {
  for (const char candidate : {';', ',', '\t'})
    for (std::size_t at = 0; at < line.size() && line[at] != '#'; ++at) {
      if (line[at] == candidate) return candidate;
      if (line[at] == '"') at = std::min(after_quotes(line, at), line.size()) - 1;
    }
  return ' ';
}

std::string_view field_at(std::string_view line, std::size_t begin, char separator) {
  std::size_t end = field_end(line, begin, separator);
  while (end > begin && blanks.find(line[end - 1]) != std::string_view::npos) --end;
  return line.substr(begin, end - begin);
}

std::size_t append_field_starts(std::string_view line, char separator, std::size_t offset,
                                std::vector<std::size_t>& starts) {
  constexpr std::size_t none = std::string_view::npos;
  const char kept = separator == ' ' ? '\0' : separator;  // a blank that separates is skipped like others
  std::size_t at = skip_blanks(line, 0, kept);
  if (at >= line.size() || line[at] == '#') return none;
  while (true) {
    starts.push_back(offset + at);
    const bool quoted = at < line.size() && line[at] == '"';
    if (quoted && after_quotes(line, at) == none) return offset + at;
    const std::size_t next = skip_blanks(line, field_end(line, at, separator), kept);
    if (next >= line.size() || line[next] == '#') return none;
    if (quoted && separator != ' ' && line[next] != separator) return offset + at;
    at = separator == ' ' ? next : skip_blanks(line, next + 1, separator);
  }
}

std::string unquoted(std::string_view field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return std::string(field);
  std::string out;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    out += field[i];
    if (field[i] == '"') ++i;
  }
  return out;
}

}  // namespace bondstatic
