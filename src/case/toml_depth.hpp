// A look at TOML text before it is parsed: nesting that would exhaust the stack of any recursive reader.
#pragma once

#include <optional>
#include <string_view>

namespace bondstatic {

struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Where brackets nest deeper than 32, or a key has more than 32 dotted parts; nothing if nowhere. Texts and
/// comments do not count.
std::optional<TextPosition> too_deep(std::string_view text);

}  // namespace bondstatic
