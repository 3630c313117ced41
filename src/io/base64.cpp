#include "io/base64.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace bondstatic {

namespace {

constexpr char letter[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

using Pair = std::array<char, 2>;

/// The two letters of twelve bits.
constexpr std::array<Pair, 4096> pair_table = [] {
  std::array<Pair, 4096> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits)
    table[bits] = {letter[bits >> 6], letter[bits & 63]};
  return table;
}();

unsigned at(std::span<const std::byte> bytes, std::size_t i) {
  return std::to_integer<unsigned>(bytes[i]);
}

}  // namespace

void append_base64(std::span<const std::byte> bytes, fmt::memory_buffer& letters) {
  const std::size_t groups = bytes.size() / 3, rest = bytes.size() % 3;
  const std::size_t before = letters.size();
  letters.resize(before + 4 * (groups + (rest > 0)));
  char* out = letters.data() + before;
  for (std::size_t i = 0; i < 3 * groups; i += 3, out += 4) {
    const unsigned bits = at(bytes, i) << 16 | at(bytes, i + 1) << 8 | at(bytes, i + 2);
    std::memcpy(out, pair_table[bits >> 12].data(), 2);
    std::memcpy(out + 2, pair_table[bits & 4095].data(), 2);
  }
  if (rest == 0) return;
  const unsigned bits = at(bytes, 3 * groups) << 16 | (rest == 2 ? at(bytes, 3 * groups + 1) << 8 : 0);
  out[0] = letter[bits >> 18];
  out[1] = letter[bits >> 12 & 63];
  out[2] = rest == 2 ? letter[bits >> 6 & 63] : '=';
  out[3] = '=';
}

}  // namespace bondstatic
