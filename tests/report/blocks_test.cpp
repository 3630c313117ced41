#include "report/blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "report/unpacked.hpp"

namespace bondstatic {
namespace {

using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Blocks, NumbersComeBackToSinglePrecision) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> number(0, 1e-7);
  std::vector<double> given(3000);
  for (double& one : given) one = number(random);
  Blocks blocks;
  const BlockRef ref = blocks.add_numbers(given, 3);
  EXPECT_EQ(ref.count, 3000);
  EXPECT_EQ(ref.components, 3);
  const std::vector<double> found = test::numbers_of(blocks, ref);
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_NEAR(found[i], given[i], std::abs(given[i]) * 0x1p-24);
}

TEST(Blocks, AnyRangeOfDoublesFits) {
  for (const double largest : {1e-320, 5e-324, 1e-300, 1e300, 1e308}) {
    Blocks blocks;
    const auto found = test::numbers_of(blocks, blocks.add_numbers(std::vector{-largest, 0.0, largest / 2}));
    EXPECT_NEAR(found[0], -largest, largest * 0x1p-24);
    EXPECT_EQ(found[1], 0);
  }
}

TEST(Blocks, WholeNumbersStayExact) {
  Blocks blocks;
  const std::vector<double> given{0, 1, 63, 12'345, 16'777'215, 16'777'216};
  EXPECT_EQ(test::numbers_of(blocks, blocks.add_numbers(given)), given);
}

TEST(Blocks, WhatIsNoNumberStaysNone) {
  Blocks blocks;
  const auto found = test::numbers_of(blocks, blocks.add_numbers(std::vector{nan, 1.0, -nan}));
  EXPECT_TRUE(std::isnan(found[0]));
  EXPECT_EQ(found[1], 1);
  EXPECT_TRUE(std::isnan(found[2]));
}

TEST(Blocks, IdsAndRowsComeBackExactly) {
  Blocks blocks;
  const std::vector<Index> ids{0, 1, 1'000'000'007, std::numeric_limits<Index>::max()};
  const std::vector<std::uint32_t> rows{7, 0, 4'000'000'000};
  EXPECT_EQ(test::ids_of(blocks, blocks.add_ids(ids)), ids);
  EXPECT_EQ(test::rows_of(blocks, blocks.add_rows(rows)), rows);
}

TEST(Blocks, EqualContentIsOneBlock) {
  Blocks blocks;
  const std::vector<double> zeros(100), ones(100, 1.0);
  const BlockRef first = blocks.add_numbers(zeros), second = blocks.add_numbers(ones);
  EXPECT_NE(first.block, second.block);
  EXPECT_EQ(blocks.add_numbers(zeros).block, first.block);
  EXPECT_EQ(blocks.add_numbers(ones).block, second.block);
  // The same bytes, another scale.
  const BlockRef twos = blocks.add_numbers(std::vector<double>(100, 2.0));
  EXPECT_EQ(test::numbers_of(blocks, twos), std::vector<double>(100, 2.0));
  EXPECT_NE(blocks.add_numbers(std::vector<double>(99)).block, first.block);
  EXPECT_EQ(blocks.size(), 3u);
}

TEST(Blocks, TextsDoNotDependOnThreads) {
  Blocks blocks;
  for (int i = 0; i < 20; ++i) blocks.add_numbers(std::vector<double>(1000, 1.0 + i / 100.0));
  EXPECT_EQ(blocks.texts(1), blocks.texts(4));
}

TEST(Blocks, OfNothingAreRead) {
  Blocks blocks;
  EXPECT_TRUE(test::numbers_of(blocks, blocks.add_numbers({})).empty());
}

TEST(Blocks, ConstantColumnsCostNextToNothing) {
  Blocks blocks;
  blocks.add_numbers(std::vector<double>(1'000'000, 0.3));
  EXPECT_LT(blocks.texts()[0].size(), 10'000u);
}

}  // namespace
}  // namespace bondstatic
