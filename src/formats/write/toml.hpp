// Values as a TOML document has them.
#pragma once

#include <string>
#include <string_view>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// In quotes, with what would end or break them escaped.
std::string toml_text(std::string_view text);
/// Reads back to the same double; always a float ("1.0", not "1").
std::string toml_number(double value);
/// "[1.0, 2.0, 3.0]"
std::string toml_vector(const Vector3& values);
/// [cell] of a case file, an empty line before it.
std::string toml_cell(const Cell& cell);

}  // namespace bondstatic
