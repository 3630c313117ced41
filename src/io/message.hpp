// What ranks tell each other, as bytes.
#pragma once

#include <string>

#include "io/archive.hpp"

namespace bondstatic {

inline const ArchiveFormat message_format{"message between processes", 1};

/// Anything that an Archive takes.
template <class T>
std::string packed(const T& message) {
  Archive archive(message_format);
  archive(message);
  return archive.finish();
}

template <class T>
T unpacked(const std::string& bytes) {
  Archive archive(message_format, bytes, "a message between processes");
  T message;
  archive(message);
  archive.expect_end();
  return message;
}

}  // namespace bondstatic
