#include "io/base64.hpp"

#include <array>
#include <cstring>
#include <vector>

#include "io/ordered_blocks.hpp"

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

constexpr std::uint8_t no_letter = 0xff;

/// The six bits of each letter.
constexpr std::array<std::uint8_t, 256> bits_table = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(no_letter);
  for (std::uint8_t bits = 0; bits < 64; ++bits) table[static_cast<unsigned char>(letter[bits])] = bits;
  return table;
}();

unsigned bits_of(char c) {
  return bits_table[static_cast<unsigned char>(c)];
}

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

void write_base64(OutputFile& file, Index size, const BytesOf& bytes_of) {
  constexpr Index block = 24 * 32768;
  write_blocks(file, size, block, [&](Index begin, Index end, fmt::memory_buffer& text) {
    std::vector<std::byte> bytes(std::size_t(end - begin));
    bytes_of(begin, bytes);
    append_base64(bytes, text);
  });
}

std::optional<std::vector<std::byte>> decode_base64(std::string_view letters) {
  if (letters.size() % 4 != 0) return std::nullopt;
  const std::size_t padding = letters.ends_with("==") ? 2 : letters.ends_with("=") ? 1 : 0;
  std::vector<std::byte> bytes(letters.size() / 4 * 3);
  unsigned seen = 0;  // bits above the six say that something was no letter
  const auto decode = [&](std::size_t group, const char* from) {
    const unsigned a = bits_of(from[0]), b = bits_of(from[1]), c = bits_of(from[2]), d = bits_of(from[3]);
    seen |= a | b | c | d;
    const unsigned bits = a << 18 | b << 12 | c << 6 | d;
    for (std::size_t i = 0; i < 3; ++i) bytes[3 * group + i] = std::byte(bits >> (16 - 8 * i) & 0xff);
  };
  const std::size_t groups = letters.size() / 4, whole = groups - (padding > 0);
  for (std::size_t group = 0; group < whole; ++group) decode(group, letters.data() + 4 * group);
  if (padding > 0) {
    char last[4] = {'A', 'A', 'A', 'A'};
    letters.copy(last, 4 - padding, 4 * whole);
    decode(whole, last);
    // Bits that belong to no byte.
    for (std::size_t i = 3 - padding; i < 3; ++i)
      if (bytes[3 * whole + i] != std::byte(0)) return std::nullopt;
  }
  if (seen > 63) return std::nullopt;
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace bondstatic
