#include "io/checksum.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace bondstatic {

namespace {

using Word = std::uint64_t;

// The specification's names.
constexpr Word prime1 = 0x9e3779b185ebca87, prime2 = 0xc2b2ae3d27d4eb4f, prime3 = 0x165667b19e3779f9,
               prime4 = 0x85ebca77c2b2ae63, prime5 = 0x27d4eb2f165667c5;

template <class T>
T number_at(const char* bytes) {
  T number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

Word stirred(Word lane, Word word) {
  return std::rotl(lane + word * prime2, 31) * prime1;
}

void take_block(std::array<Word, 4>& lanes, const char* block) {
  for (std::size_t i = 0; i < 4; ++i) lanes[i] = stirred(lanes[i], number_at<Word>(block + 8 * i));
}

Word merged(const std::array<Word, 4>& lanes) {
  Word value =
      std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
  for (const Word lane : lanes) value = (value ^ stirred(0, lane)) * prime1 + prime4;
  return value;
}

Word with_rest(Word value, std::string_view rest) {
  for (; rest.size() >= 8; rest.remove_prefix(8))
    value = std::rotl(value ^ stirred(0, number_at<Word>(rest.data())), 27) * prime1 + prime4;
  if (rest.size() >= 4) {
    value = std::rotl(value ^ number_at<std::uint32_t>(rest.data()) * prime1, 23) * prime2 + prime3;
    rest.remove_prefix(4);
  }
  for (const char byte : rest)
    value = std::rotl(value ^ static_cast<unsigned char>(byte) * prime5, 11) * prime1;
  return value;
}

}  // namespace

Checksum::Checksum() : lanes_{prime1 + prime2, prime2, 0, 0 - prime1} {}

void Checksum::add(std::string_view bytes) {
  const std::size_t filled = size_ % block;
  size_ += bytes.size();
  if (filled > 0) {
    const std::string_view head = bytes.substr(0, block - filled);
    std::copy(head.begin(), head.end(), rest_.begin() + filled);
    bytes.remove_prefix(head.size());
    if (filled + head.size() < block) return;
    take_block(lanes_, rest_.data());
  }
  // A copy can stay in registers.
  std::array<Word, 4> lanes = lanes_;
  for (; bytes.size() >= block; bytes.remove_prefix(block)) take_block(lanes, bytes.data());
  lanes_ = lanes;
  std::copy(bytes.begin(), bytes.end(), rest_.begin());
}

std::uint64_t Checksum::value() const {
  const Word start = size_ >= block ? merged(lanes_) : prime5;
  Word value = with_rest(start + size_, std::string_view(rest_.data(), size_ % block));
  value = (value ^ value >> 33) * prime2;
  value = (value ^ value >> 29) * prime3;
  return value ^ value >> 32;
}

std::uint64_t checksum(std::string_view bytes) {
  Checksum sum;
  sum.add(bytes);
  return sum.value();
}

}  // namespace bondstatic
