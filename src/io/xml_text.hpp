// Text inside of XML, between quotes or tags.
#pragma once

#include <string>
#include <string_view>

namespace bondstatic {

/// Escapes what XML would take for its own; control characters, which it does not allow at all, are blanks.
std::string xml_text(std::string_view text);

}  // namespace bondstatic
