#include "formats/write/toml.hpp"

#include <fmt/format.h>

namespace bondstatic {

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", code);
    else
      out += c;
  }
  return out + '"';
}

std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_vector(const Vector3& values) {
  return fmt::format("[{}, {}, {}]", toml_number(values[0]), toml_number(values[1]), toml_number(values[2]));
}

std::string toml_cell(const Cell& cell) {
  std::string periodic;
  for (std::size_t i = 0; i < 3; ++i)
    if (cell.periodic[i]) periodic += fmt::format("{}\"{}\"", periodic.empty() ? "" : ", ", "xyz"[i]);
  return fmt::format("\n[cell]\nedges = [{}, {}, {}]\norigin = {}\nperiodic = [{}]\n",
                     toml_vector(cell.edges.col(0)), toml_vector(cell.edges.col(1)),
                     toml_vector(cell.edges.col(2)), toml_vector(cell.origin), periodic);
}

}  // namespace bondstatic
