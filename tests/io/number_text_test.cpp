// Numbers of tables against fmt, whose shortest form they must have to the letter.
#include "io/number_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace bondstatic {
namespace {

template <class Number>
std::string text_of(Number value) {
  char text[longest_number];
  return {text, write_number(text, value)};
}

TEST(NumberText, KnownOnes) {
  EXPECT_EQ(text_of(0.0), "0");
  EXPECT_EQ(text_of(-0.0), "-0");
  EXPECT_EQ(text_of(0.001), "0.001");
  EXPECT_EQ(text_of(0.0001), "0.0001");
  EXPECT_EQ(text_of(0.00001), "1e-05");
  EXPECT_EQ(text_of(1e15), "1000000000000000");
  EXPECT_EQ(text_of(1e16), "1e+16");
  EXPECT_EQ(text_of(1.5e300), "1.5e+300");
  EXPECT_EQ(text_of(5e-324), "5e-324");
  EXPECT_EQ(text_of(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(text_of(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(text_of(std::numeric_limits<Index>::min()), "-9223372036854775808");
}

TEST(NumberText, EveryExponentAndItsBorders) {
  for (std::uint64_t exponent = 0; exponent < 2047; ++exponent)
    for (const std::uint64_t fraction : {0ull, 1ull, 2ull, (1ull << 52) - 2, (1ull << 52) - 1}) {
      const double value = std::bit_cast<double>(exponent << 52 | fraction);
      ASSERT_EQ(text_of(value), fmt::format("{}", value));
      ASSERT_EQ(text_of(-value), fmt::format("{}", -value));
    }
}

TEST(NumberText, RandomOnesOfManyKinds) {
  std::mt19937_64 random(4);
  const auto check = [](double value) {
    if (!std::isfinite(value)) return;
    ASSERT_EQ(text_of(value), fmt::format("{}", value));
  };
  for (int i = 0; i < 100000; ++i) {
    const double part = double(random() >> 11) * 0x1p-53;
    check(std::bit_cast<double>(random()));
    check((part - 0.5) * std::pow(10.0, int(random() % 12) - 6));
    check(std::round(part * 1e6) / 1e3);
    check(double(random() >> (random() % 64)));
  }
}

}  // namespace
}  // namespace bondstatic
