#include "report/blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

#include "bondstatic/error.hpp"
#include "io/base64.hpp"
#include "io/checksum.hpp"

namespace bondstatic {

namespace {

template <class Word>
std::vector<unsigned char> planes_of(std::span<const Word> words) {
  std::vector<unsigned char> planes(words.size() * sizeof(Word));
  for (std::size_t plane = 0; plane < sizeof(Word); ++plane)
    for (std::size_t i = 0; i < words.size(); ++i)
      planes[plane * words.size() + i] = static_cast<unsigned char>(words[i] >> 8 * plane);
  return planes;
}

using Bytes = std::vector<unsigned char>;

Bytes compressed(const Bytes& planes, int strategy) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, strategy) != Z_OK)
    throw std::bad_alloc();
  Bytes out(deflateBound(&stream, uLong(planes.size())));
  stream.next_in = const_cast<unsigned char*>(planes.data());  // zlib only reads it
  stream.avail_in = uInt(planes.size());
  stream.next_out = out.data();
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// Forces of a large packing have nothing that repeats but runs of equal bytes; ids, lattices and small
/// models may have more.
std::string text_of(const Bytes& planes) {
  Bytes best = compressed(planes, Z_RLE);
  if (Bytes other = compressed(planes, Z_DEFAULT_STRATEGY); other.size() < best.size())
    best = std::move(other);
  fmt::memory_buffer letters;
  append_base64(std::as_bytes(std::span(best)), letters);
  return {letters.data(), letters.size()};
}

double scale_for(std::span<const double> numbers) {
  double largest = 0;
  for (const double number : numbers)
    if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
  if (largest == 0) return 1;
  int exponent = 0;
  std::frexp(largest, &exponent);
  // 2^1024 is no double.
  return std::ldexp(1.0, std::min(exponent, std::numeric_limits<double>::max_exponent - 1));
}

}  // namespace

template <class Word>
int Blocks::add(std::span<const Word> words) {
  std::vector<unsigned char> planes = planes_of(words);
  const std::uint64_t sum =
      checksum(std::string_view(reinterpret_cast<const char*>(planes.data()), planes.size()));
  const auto [begin, end] = with_checksum_.equal_range(sum);
  for (auto same = begin; same != end; ++same)
    if (planes_[std::size_t(same->second)] == planes) return same->second;
  const int block = int(planes_.size());
  planes_.push_back(std::move(planes));
  with_checksum_.emplace(sum, block);
  return block;
}

BlockRef Blocks::add_numbers(std::span<const double> numbers, int components) {
  const double scale = scale_for(numbers);
  std::vector<std::uint32_t> words;
  words.reserve(numbers.size());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();  // always the same bits
  for (const double number : numbers)
    words.push_back(std::bit_cast<std::uint32_t>(std::isnan(number) ? nan : float(number / scale)));
  return {add(std::span<const std::uint32_t>(words)), BlockRef::Type::f32, Index(numbers.size()), components,
          scale};
}

BlockRef Blocks::add_rows(std::span<const std::uint32_t> rows) {
  return {add(rows), BlockRef::Type::u32, Index(rows.size())};
}

BlockRef Blocks::add_ids(std::span<const Index> ids) {
  std::vector<std::uint64_t> words(ids.begin(), ids.end());
  return {add(std::span<const std::uint64_t>(words)), BlockRef::Type::i64, Index(ids.size())};
}

std::vector<std::string> Blocks::texts(int threads) const {
  std::vector<std::string> texts(planes_.size());
  bool failed = false;
#pragma omp parallel for schedule(dynamic) num_threads(threads) reduction(|| : failed)
  for (std::size_t block = 0; block < planes_.size(); ++block) {
    try {
      texts[block] = text_of(planes_[block]);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
  }
  if (failed)
    throw MemoryError("too little memory for the numbers of the report\n    cure: close other programs");
  return texts;
}

}  // namespace bondstatic
