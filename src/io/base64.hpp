// Base64 (RFC 4648, with padding): three bytes become four letters.
#pragma once

#include <fmt/format.h>

#include <span>

namespace bondstatic {

/// Appends the letters of `bytes`, padded where they are no multiple of three.
void append_base64(std::span<const std::byte> bytes, fmt::memory_buffer& letters);

}  // namespace bondstatic
