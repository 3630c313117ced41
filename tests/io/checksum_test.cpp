#include "io/checksum.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace bondstatic {
namespace {

std::string pattern(int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += char(i * i);
  return bytes;
}

/// Values of another implementation, LLVM's.
TEST(Checksum, IsXxh64) {
  EXPECT_EQ(checksum(""), 0xef46db3751d8e999u);
  EXPECT_EQ(checksum("abc"), 0x44bc2cf5ad770999u);
  EXPECT_EQ(checksum(pattern(300)), 0x81d35de62068b9feu);
  std::uint64_t combined = 0;
  for (int size = 0; size <= 300; ++size) combined ^= checksum(pattern(size));
  EXPECT_EQ(combined, 0x202d03d318f598f4u);
}

TEST(Checksum, DoesNotDependOnHowTheBytesAreCut) {
  const std::string bytes = pattern(300);
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    Checksum sum;
    for (std::size_t i = 0; i < bytes.size(); i += piece) sum.add(std::string_view(bytes).substr(i, piece));
    EXPECT_EQ(sum.value(), checksum(bytes)) << piece;
  }
}

TEST(Checksum, ChangesWithAnyOneOrTwoBits) {
  std::string bytes(96, 'x');
  std::set<std::uint64_t> seen;
  const auto flip = [&](std::size_t bit) { bytes[bit / 8] = char(bytes[bit / 8] ^ 1 << bit % 8); };
  const std::size_t bits = 8 * bytes.size();
  for (std::size_t i = 0; i < bits; ++i)
    for (std::size_t j = i; j < bits; ++j) {
      flip(i);
      if (j != i) flip(j);
      seen.insert(checksum(bytes));
      flip(i);
      if (j != i) flip(j);
    }
  EXPECT_EQ(seen.size(), bits * (bits + 1) / 2);
  EXPECT_EQ(seen.count(checksum(bytes)), 0u);
}

}  // namespace
}  // namespace bondstatic
