#include "io/number_text.hpp"

#include <charconv>
#include <cmath>

namespace bondstatic {

char* write_number(char* out, Index value) {
  return std::to_chars(out, out + longest_number, value).ptr;
}

char* write_number(char* out, double value) {
  if (std::isnan(value)) return out;
  constexpr double lowest_plain = 1e-4, above_plain = 1e16;
  const double magnitude = std::abs(value);
  const bool plain = magnitude == 0 || (magnitude >= lowest_plain && magnitude < above_plain);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return std::to_chars(out, out + longest_number, value, format).ptr;
}

}  // namespace bondstatic
