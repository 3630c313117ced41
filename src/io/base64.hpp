// Base64 (RFC 4648, with padding): three bytes become four letters.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bondstatic/types.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

/// Appends the letters of `bytes`, padded where they are no multiple of three.
void append_base64(std::span<const std::byte> bytes, fmt::memory_buffer& letters);

/// Bytes [begin, begin + into.size()) of something longer; called by several threads at once. `begin` is a
/// multiple of 24: whole groups of letters and whole numbers of eight bytes.
using BytesOf = std::function<void(Index begin, std::span<std::byte> into)>;

/// Writes `size` bytes as one stream of letters.
void write_base64(OutputFile& file, Index size, const BytesOf& bytes_of);

/// The bytes of one padded stream; nothing where it is none (a line break within it is no letter, either).
std::optional<std::vector<std::byte>> decode_base64(std::string_view letters);

}  // namespace bondstatic
