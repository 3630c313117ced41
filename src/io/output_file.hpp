// One output file, written through a large buffer. Every failure is an Error that names the path.
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// Called between pieces of work; may throw to give up (a pending interrupt).
using Checkpoint = std::function<void()>;

class OutputFile {
 public:
  enum class Begin { empty, at_end };

  /// Opens `path` for writing; `shown` is the name that messages use. What is written is added to `*written`,
  /// where that is given. Throws Error.
  OutputFile(const std::filesystem::path& path, std::string shown, Checkpoint checkpoint = {},
             int threads = 1, Begin begin = Begin::empty, std::atomic<Index>* written = nullptr);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Format into this, then call flush_if_large().
  fmt::memory_buffer& buffer() { return buffer_; }
  void append(std::string_view text);
  /// Appends all that is in another file. Throws Error.
  void append_file(const std::filesystem::path& path);
  /// Threads that may format what goes into it.
  int threads() const { return threads_; }
  void flush_if_large();

  /// Writes what is left and closes; only after this is the file known to be whole. Throws Error.
  void close();

 private:
  void flush();
  void write(std::string_view text);

  std::string shown_;
  Checkpoint checkpoint_;
  int threads_;
  std::atomic<Index>* written_;
  int descriptor_ = -1;
  fmt::memory_buffer buffer_;
};

}  // namespace bondstatic
