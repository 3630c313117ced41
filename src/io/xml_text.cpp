#include "io/xml_text.hpp"

namespace bondstatic {

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += byte < 32 || byte == 127 ? ' ' : c;
  }
  return escaped;
}

}  // namespace bondstatic
