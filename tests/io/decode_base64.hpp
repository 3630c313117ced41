// Base64 read back, slowly.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace bondstatic::test {

inline std::vector<std::byte> decode_base64(std::string_view letters) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_EQ(letters.size() % 4, 0u);
  const std::size_t padding = letters.ends_with("==") ? 2 : letters.ends_with("=") ? 1 : 0;
  letters.remove_suffix(padding);
  std::vector<std::byte> bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char letter : letters) {
    const std::size_t six = alphabet.find(letter);
    EXPECT_NE(six, std::string_view::npos) << letter;
    bits = bits << 6 | unsigned(six & 63);
    if ((held += 6) < 8) continue;
    held -= 8;
    bytes.push_back(std::byte(bits >> held & 255));
  }
  EXPECT_EQ(bits & ((1u << held) - 1), 0u) << "bits that belong to no byte";
  return bytes;
}

}  // namespace bondstatic::test
