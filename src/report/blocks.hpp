// Numbers on their way into the page, as src/report/page/blocks.ts reads them: little endian, byte plane by
// byte plane (first all lowest bytes, ...), which compresses far better than number by number, then zlib,
// then base64.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "report/page_data.hpp"

namespace bondstatic {

class Blocks {
 public:
  /// To single precision, NaN stays NaN. The scale is the power of two above the largest magnitude: no number
  /// leaves the range of a float, and whole numbers below 2^24 stay exact.
  BlockRef add_numbers(std::span<const double> numbers, int components = 1);
  BlockRef add_rows(std::span<const std::uint32_t> rows);
  BlockRef add_ids(std::span<const Index> ids);

  /// Equal content is one block.
  std::size_t size() const { return planes_.size(); }

  /// The text of each block; they are compressed several at a time.
  std::vector<std::string> texts(int threads = 1) const;

 private:
  template <class Word>
  int add(std::span<const Word> words);

  std::vector<std::vector<unsigned char>> planes_;             ///< of each block
  std::unordered_multimap<std::uint64_t, int> with_checksum_;  ///< its block
};

}  // namespace bondstatic
