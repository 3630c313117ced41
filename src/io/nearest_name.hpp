// Which of the known names a misspelt one was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bondstatic {

/// The known name with the fewest edits (insertion, deletion, change, swap of neighbours; letter case is
/// free), or "" where none is near: more edits than a third of the longer name, at least one.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

/// "a, b, c".
std::string name_list(std::span<const std::string> names);

}  // namespace bondstatic
