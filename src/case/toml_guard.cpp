#include "case/toml_guard.hpp"

#include <algorithm>
#include <string_view>

namespace bondstatic {
namespace {

constexpr int deepest = 32;
constexpr auto nowhere = std::string_view::npos;

bool beyond_ascii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

struct Quoted {
  std::size_t end = 0;            ///< first character after the closing quotes
  std::size_t stray = nowhere;    ///< a character beyond ASCII behind a line-ending backslash
  std::size_t foreign = nowhere;  ///< the first character beyond ASCII
};

/// The text that opens at `begin`: "..", '..', """..""" or '''..'''.
Quoted quoted_at(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool triple = text.substr(begin, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  Quoted found;
  for (std::size_t at = begin + (triple ? 3 : 1); at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      const std::size_t next = text.find_first_not_of(" \t\r\n", at + 1);
      if (triple && next != nowhere && beyond_ascii(text[next]) && found.stray == nowhere) found.stray = next;
      ++at;
    } else if (text[at] == '\n' && !triple) {
      found.end = at;
      return found;
    } else if (text[at] == quote && (!triple || text.substr(at, 3) == text.substr(begin, 3))) {
      found.end = at + (triple ? 3 : 1);
      return found;
    } else if (beyond_ascii(text[at]) && found.foreign == nowhere) {
      found.foreign = at;
    }
  }
  found.end = text.size();
  return found;
}

class Guard {
 public:
  explicit Guard(std::string_view text) : text_(text) {}

  /// Position of the first fault; `deep` tells which of the two kinds.
  std::size_t find(bool& deep) {
    while (at_ < text_.size()) {
      const std::size_t fault = step(deep);
      if (fault != nowhere) return fault;
    }
    return nowhere;
  }

 private:
  std::size_t step(bool& deep) {
    const char c = text_[at_];
    if (c == '"' || c == '\'') return step_over_quotes();
    if (c == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return nowhere;
    }
    if (beyond_ascii(c)) return at_;
    if (c == '\n') in_header_ = false;
    if (c == '[' && depth_ == 0 && line_is_blank_before()) in_header_ = true;
    if (c == '[' || c == '{') ++depth_;
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    if (c == '.') ++dots_;
    if (c == '\n' || c == '=' || c == ',' || c == '{') dots_ = 0;
    if ((deep = depth_ > deepest || dots_ > deepest)) return at_;
    ++at_;
    return nowhere;
  }

  /// A text is a key where = or . follows it, and in a [header].
  std::size_t step_over_quotes() {
    const Quoted quoted = quoted_at(text_, at_);
    const std::size_t next = text_.find_first_not_of(" \t", quoted.end);
    const bool is_key =
        in_header_ || (next != nowhere && (text_[next] == '=' || text_[next] == '.')) || after_dot();
    at_ = quoted.end;
    return is_key && quoted.foreign != nowhere ? quoted.foreign : quoted.stray;
  }

  bool after_dot() const {
    const std::size_t before = at_ == 0 ? nowhere : text_.find_last_not_of(" \t", at_ - 1);
    return before != nowhere && text_[before] == '.';
  }

  bool line_is_blank_before() const {
    const std::size_t before = at_ == 0 ? nowhere : text_.find_last_not_of(" \t", at_ - 1);
    return before == nowhere || text_[before] == '\n';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int dots_ = 0;
  bool in_header_ = false;
};

Place place_at(std::string_view text, std::size_t at, const std::string& file) {
  const std::string_view before = text.substr(0, at);
  const std::size_t newline = before.rfind('\n');
  const std::string_view line = newline == nowhere ? before : before.substr(newline + 1);
  const auto characters = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return {file, int(std::count(before.begin(), before.end(), '\n')) + 1, int(characters) + 1};
}

}  // namespace

std::optional<Fault> unfit_for_parsing(const std::string& text, const std::string& file) {
  bool deep = false;
  const std::size_t at = Guard(text).find(deep);
  if (at == nowhere) return std::nullopt;
  if (deep)
    return Fault{place_at(text, at, file), "values nested or keys chained deeper than 32",
                 "write the case flatter: no key of a case file needs more than four levels"};
  return Fault{place_at(text, at, file), "a character beyond ASCII where none may be",
               "put texts in plain quotes; look for typographic quotes, no-break spaces and accents in keys"};
}

}  // namespace bondstatic
