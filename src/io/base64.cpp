#include "io/base64.hpp"

namespace bondstatic {

void Base64Stream::append(std::span<const std::byte> bytes) {
  std::size_t since_flush = 0;
  for (const std::byte byte : bytes) {
    pending_[pending_count_++] = std::to_integer<unsigned char>(byte);
    if (pending_count_ == 3) put(3);
    if (++since_flush == 4096) {
      file_.flush_if_large();
      since_flush = 0;
    }
  }
}

void Base64Stream::finish() {
  if (pending_count_ > 0) put(pending_count_);
  file_.flush_if_large();
}

void Base64Stream::put(int count) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int i = count; i < 3; ++i) pending_[i] = 0;
  const unsigned bits = unsigned(pending_[0]) << 16 | unsigned(pending_[1]) << 8 | pending_[2];
  const char four[4] = {letters[bits >> 18], letters[bits >> 12 & 63],
                        count > 1 ? letters[bits >> 6 & 63] : '=', count > 2 ? letters[bits & 63] : '='};
  file_.buffer().append(four, four + 4);
  pending_count_ = 0;
}

}  // namespace bondstatic
