// Numbers and words in the lines of a text file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// NaN where the field is no number, infinite where it is out of the range of a double. A sign + is allowed.
double number_field(std::string_view field);

/// Also of nan, which number_field() does not tell from a word.
bool is_number_field(std::string_view field);

/// Nothing where the field is no whole number of 64 bits; "12.0" is none.
std::optional<Index> whole_number_field(std::string_view field);

/// The fields of a line between blanks and tabs, up to a # that begins one.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields);

}  // namespace bondstatic
