#include "formats/musen/line.hpp"

#include <fmt/format.h>

namespace bondstatic {

std::optional<Index> MusenLine::whole(std::string_view name) {
  if (at_end()) {
    fault(fmt::format("the line ends where {} must be", name));
    return std::nullopt;
  }
  return fields_.whole_number(at_++, name);
}

std::optional<std::array<double, 9>> MusenLine::numbers(int count) {
  std::array<double, 9> out{};
  for (int i = 0; i < count; ++i) {
    if (at_end()) {
      fault(
          fmt::format("the line ends where {} more number{} must be", count - i, count - i == 1 ? "" : "s"));
      return std::nullopt;
    }
    const auto number = fields_.number(at_++, "the value");
    if (!number) return std::nullopt;
    out[std::size_t(i)] = *number;
  }
  return out;
}

bool MusenLine::vector(Vector3& out) {
  const auto three = numbers(3);
  if (three) out = {(*three)[0], (*three)[1], (*three)[2]};
  return three.has_value();
}

}  // namespace bondstatic
