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

/// Appends `offset` plus the positions of the first characters of the fields of a line; a # outside of quotes
/// ends the line. Returns `offset` plus where a quoted field is not closed in its line, or has text after it;
/// npos where there is none. What follows such a field is not looked at.
std::size_t append_field_starts(std::string_view line, char separator, std::size_t offset,
                                std::vector<std::size_t>& starts);

/// Without the quotes around it, and "" inside of them as ".
std::string unquoted(std::string_view field);

}  // namespace bondstatic
