// Lines of a text file of any size, read through a buffer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bondstatic/error.hpp"
#include "io/text_file.hpp"

namespace bondstatic {

class LineReader {
 public:
  /// Nothing, and a fault with the place that names the file, where it is missing, a folder, a device or
  /// unreadable, or a pipe: its text would be gone after the look that tells its format.
  static std::optional<LineReader> open(const std::string& path, const Place& named_at,
                                        std::vector<Fault>& faults);

  /// The next line without its end (LF or CRLF) and, on the first, without a byte order mark; it stands until
  /// the next call. Nothing at the end, and where reading is at fault: a NUL byte (a binary file), a line
  /// longer than 1 MiB, an error of the file system; failed() then says so, and the fault has been appended
  /// to `faults`.
  std::optional<std::string_view> next(std::vector<Fault>& faults);

  bool failed() const { return failed_; }
  int line() const { return line_; }  ///< number of the line next() returned last, from 1
  Place place(int column = 1) const { return {file_, line_, column}; }  ///< in that line
  const std::string& file() const { return file_; }
  double part() const;                          ///< of the file's bytes, read so far
  std::uint64_t size() const { return size_; }  ///< bytes of the file
  /// The line next() returned last has its LF; without one it may be cut short.
  bool line_ended() const { return line_ended_; }

  /// Where the line next() returned last begins; with its number a bookmark to return to.
  std::uint64_t offset() const { return line_offset_; }
  /// next() gives the line that begins at `offset`, whose number is `line`. Only for files not at fault.
  void go_to(std::uint64_t offset, int line, std::vector<Fault>& faults);

 private:
  LineReader(TextStream stream, const std::string& file, std::uint64_t size);
  bool refill(std::vector<Fault>& faults);
  void fail(std::vector<Fault>& faults, const std::string& message, const std::string& cure);

  TextStream stream_;
  std::string file_;
  std::uint64_t size_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // of what is in the buffer and not given out
  std::uint64_t buffer_offset_ = 0;  // of buffer_[0] in the file
  std::uint64_t line_offset_ = 0;
  int line_ = 0;
  bool line_ended_ = true, at_end_ = false, failed_ = false;
};

}  // namespace bondstatic
