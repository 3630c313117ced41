// Cutting one line of a table into fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bondstatic {

/// The separator that a header line uses: the first of ; , tab that it has outside of quotes, else ' ' for
/// blanks.
char separator_of(std::string_view line);

/// What stands between line[begin] and the next separator, without the blanks around it; quotes are kept.
std::string_view field_at(std::string_view line, std::size_t begin, char separator);

struct FieldStarts {
  std::vector<std::size_t> begins;
  std::size_t open_quote =
      std::string_view::npos;  ///< where a quoted field is not closed in its line, or has text after it
};

/// First characters of the fields of a line. A # outside of quotes ends the line.
FieldStarts field_starts(std::string_view line, char separator);

/// Without the quotes around it, and "" inside of them as ".
std::string unquoted(std::string_view field);

}  // namespace bondstatic
