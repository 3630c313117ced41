#include "app/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace bondstatic {

namespace {

/// Characters, not bytes: all but the continuation bytes of UTF-8.
std::size_t width_of(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string styled(const std::string& text, const char* style, std::FILE* stream) {
  return shows_style(stream) ? fmt::format("\033[{}m{}\033[0m", style, text) : text;
}

}  // namespace

bool shows_style(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return !(no_color && *no_color) && !(terminal && std::strcmp(terminal, "dumb") == 0) &&
         isatty(fileno(stream));
}

std::string bold(const std::string& text, std::FILE* stream) {
  return styled(text, "1", stream);
}

std::string red(const std::string& text, std::FILE* stream) {
  return styled(text, "31", stream);
}

std::string to_text(const TextTable& table, int indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : table.rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text;
  for (const auto& row : table.rows) {
    std::string line(std::size_t(indent), ' ');
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(widths[c] - width_of(row[c]), ' ');
      const bool right = c < table.right.size() && table.right[c];
      line += (c == 0 ? "" : "  ") + (right ? padding + row[c] : row[c] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string wrapped(const std::string& text, int indent) {
  constexpr std::size_t widest = 100;
  std::string result;
  std::size_t column = std::size_t(indent);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!result.empty() && column + 1 + width_of(word) > widest) {
      result += '\n' + std::string(std::size_t(indent), ' ');
      column = std::size_t(indent);
    } else if (!result.empty()) {
      result += ' ';
      ++column;
    }
    result += word;
    column += width_of(word);
    begin = end + 1;
  }
  return result;
}

std::string seconds_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::string bytes_text(double bytes) {
  if (bytes >= 1e9) return fmt::format("{:.3g} GB", bytes / 1e9);
  if (bytes >= 1e6) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} kB", bytes / 1e3);
}

}  // namespace bondstatic
