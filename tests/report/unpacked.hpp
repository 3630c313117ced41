// Blocks read back, as the page does.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "io/decode_base64.hpp"
#include "report/blocks.hpp"

namespace bondstatic::test {

/// The stored words of a block: unsigned integers of as many bytes as its type has.
template <class Word>
std::vector<Word> words_of(const Blocks& blocks, const BlockRef& ref) {
  if (ref.block < 0) return {};
  const auto stream = decode_base64(blocks.texts().at(std::size_t(ref.block)));
  std::vector<unsigned char> planes(std::size_t(ref.count) * sizeof(Word) + 1);
  uLongf size = uLongf(planes.size());
  EXPECT_EQ(uncompress(planes.data(), &size, reinterpret_cast<const Bytef*>(stream.data()), stream.size()),
            Z_OK);
  EXPECT_EQ(size, std::size_t(ref.count) * sizeof(Word));
  std::vector<Word> words(std::size_t(ref.count));
  for (std::size_t plane = 0; plane < sizeof(Word); ++plane)
    for (std::size_t i = 0; i < words.size(); ++i)
      words[i] |= Word(planes[plane * words.size() + i]) << 8 * plane;
  return words;
}

/// Scaled.
inline std::vector<double> numbers_of(const Blocks& blocks, const BlockRef& ref) {
  EXPECT_EQ(ref.type, BlockRef::Type::f32);
  std::vector<double> numbers;
  for (const std::uint32_t word : words_of<std::uint32_t>(blocks, ref)) {
    float stored;
    std::memcpy(&stored, &word, sizeof stored);
    numbers.push_back(ref.scale * double(stored));
  }
  return numbers;
}

inline std::vector<std::uint32_t> rows_of(const Blocks& blocks, const BlockRef& ref) {
  EXPECT_EQ(ref.type, BlockRef::Type::u32);
  return words_of<std::uint32_t>(blocks, ref);
}

inline std::vector<Index> ids_of(const Blocks& blocks, const BlockRef& ref) {
  EXPECT_EQ(ref.type, BlockRef::Type::i64);
  const auto words = words_of<std::uint64_t>(blocks, ref);
  return {words.begin(), words.end()};
}

}  // namespace bondstatic::test
