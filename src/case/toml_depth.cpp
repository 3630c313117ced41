#include "case/toml_depth.hpp"

#include <algorithm>

namespace bondstatic {
namespace {

constexpr int deepest = 32;

/// First character after the text that opens at `begin`: "..", '..', """..""" or '''..'''.
std::size_t after_quotes(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool triple = text.substr(begin, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  std::size_t at = begin + (triple ? 3 : 1);
  for (; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == '\n' && !triple) {
      return at;
    } else if (text[at] == quote) {
      if (!triple) return at + 1;
      if (text.substr(at, 3) == text.substr(begin, 3)) return at + 3;
    }
  }
  return text.size();
}

TextPosition position_at(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t newline = before.rfind('\n');
  const auto lines = std::count(before.begin(), before.end(), '\n');
  return {int(lines) + 1, int(newline == std::string_view::npos ? at : at - newline - 1) + 1};
}

}  // namespace

std::optional<TextPosition> too_deep(std::string_view text) {
  int brackets = 0, dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = after_quotes(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++brackets;
    if ((c == ']' || c == '}') && brackets > 0) --brackets;
    if (c == '.') ++dots;
    if (c == '\n' || c == '=' || c == ',' || c == '{') dots = 0;
    if (brackets > deepest || dots > deepest) return position_at(text, at);
    ++at;
  }
  return std::nullopt;
}

}  // namespace bondstatic
