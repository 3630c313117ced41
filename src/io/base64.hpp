// Base64 (RFC 4648, with padding), in pieces: three bytes become four letters.
#pragma once

#include <span>

#include "io/output_file.hpp"

namespace bondstatic {

class Base64Stream {
 public:
  explicit Base64Stream(OutputFile& file) : file_(file) {}

  void append(std::span<const std::byte> bytes);
  /// Pads and ends the stream.
  void finish();

 private:
  void put(int count);

  OutputFile& file_;
  unsigned char pending_[3] = {};
  int pending_count_ = 0;
};

}  // namespace bondstatic
