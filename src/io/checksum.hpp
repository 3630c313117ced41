// A fast 64-bit checksum against damage, not against forgery: XXH64 with seed 0, as its specification has it
// (https://github.com/Cyan4973/xxHash, doc/xxhash_spec.md). It takes 32 bytes at a time, so that gigabytes
// cost a fraction of a second; damage goes unnoticed with a chance of about 2^-64.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace bondstatic {

class Checksum {
 public:
  Checksum();

  /// The value depends on all bytes so far, not on how they were cut into pieces.
  void add(std::string_view bytes);
  std::uint64_t value() const;

 private:
  static constexpr std::size_t block = 32;

  std::array<std::uint64_t, 4> lanes_;
  std::array<char, block> rest_{};  ///< the last size_ % block bytes, which fill no block yet
  std::uint64_t size_ = 0;
};

std::uint64_t checksum(std::string_view bytes);

}  // namespace bondstatic
