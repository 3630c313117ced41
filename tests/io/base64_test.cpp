#include "io/base64.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "io/decode_base64.hpp"

namespace bondstatic {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string encoded(const std::string& text) {
  fmt::memory_buffer letters;
  append_base64(bytes_of(text), letters);
  return {letters.data(), letters.size()};
}

std::string decoded(const std::string& letters) {
  const auto bytes = test::decode_base64(letters);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// RFC 4648, section 10.
TEST(Base64, TestVectorsOfItsStandard) {
  const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, letters] : vectors) {
    EXPECT_EQ(encoded(text), letters);
    EXPECT_EQ(decoded(letters), text);
  }
}

TEST(Base64, EveryByteComesBack) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += char(7 * i * i + i / 3);
  for (std::size_t size : {1000, 999, 998})
    EXPECT_EQ(decoded(encoded(text.substr(0, size))), text.substr(0, size));
}

}  // namespace
}  // namespace bondstatic
