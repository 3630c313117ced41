// A look at TOML text before it is parsed, for what the parser itself cannot be trusted with: nesting that
// exhausts the stack of any recursive reader, and characters beyond ASCII where TOML has none, which
// toml++ 3.3 takes for impossible (undefined behaviour).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// The first such fault, if any: brackets deeper than 32, keys of more than 32 dotted parts, characters
/// beyond ASCII in keys, outside of texts and comments, or behind a line-ending backslash.
std::optional<Fault> unfit_for_parsing(const std::string& text, const std::string& file);

}  // namespace bondstatic
