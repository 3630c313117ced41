#include "io/line_reader.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

namespace bondstatic {
namespace {

constexpr std::size_t longest_line = 1 << 20;
constexpr std::size_t piece = 1 << 18;

}  // namespace

std::optional<LineReader> LineReader::open(const std::string& path, const Place& named_at,
                                           std::vector<Fault>& faults) {
  TextStream stream = open_text_file(path, named_at, faults);
  if (!stream) return std::nullopt;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) {
    faults.push_back({named_at, "\"" + path + "\" is a pipe, which can be read only once",
                      "write it to a file first, and give that"});
    return std::nullopt;
  }
  return LineReader(std::move(stream), path, size);
}

LineReader::LineReader(TextStream stream, const std::string& file, std::uint64_t size)
    : stream_(std::move(stream)), file_(file), size_(size) {
  std::setvbuf(stream_.get(), nullptr, _IONBF, 0);  // the buffer here is enough
  buffer_.resize(std::size_t(std::min<std::uint64_t>(size + 1, piece)));
}

double LineReader::part() const {
  if (size_ == 0) return 1;
  return std::min(1.0, double(buffer_offset_ + begin_) / double(size_));
}

void LineReader::fail(std::vector<Fault>& faults, const std::string& message, const std::string& cure) {
  failed_ = true;
  faults.push_back({place(), message, cure});
}

bool LineReader::refill(std::vector<Fault>& faults) {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  buffer_offset_ += begin_;
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) buffer_.resize(std::max(2 * buffer_.size(), std::size_t(256)));
  const std::size_t count = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, stream_.get());
  end_ += count;
  if (count == 0) at_end_ = true;
  if (!std::ferror(stream_.get())) return true;
  fail(faults, "the file cannot be read on", "check the disk and the file");
  return false;
}

std::optional<std::string_view> LineReader::next(std::vector<Fault>& faults) {
  if (failed_) return std::nullopt;
  std::size_t searched = 0;
  const char* stop = nullptr;
  while (true) {
    stop = static_cast<const char*>(
        std::memchr(buffer_.data() + begin_ + searched, '\n', end_ - begin_ - searched));
    searched = end_ - begin_;
    if (stop || at_end_ || searched > longest_line) break;
    if (!refill(faults)) return std::nullopt;
  }
  if (!stop && searched == 0) return std::nullopt;
  const char* begin = buffer_.data() + begin_;
  std::string_view text(begin, stop ? std::size_t(stop - begin) : searched);
  line_offset_ = buffer_offset_ + begin_;
  if (line_ < std::numeric_limits<int>::max()) ++line_;
  line_ended_ = stop != nullptr;
  begin_ += text.size() + (stop ? 1 : 0);
  if (const std::size_t at = text.find('\0'); at != std::string_view::npos) {
    fail(faults, "the file is binary, not text: it has a NUL byte here",
         "give a text file; unpack what is compressed, and save as UTF-8, not UTF-16");
    faults.back().place.column = int(std::min<std::size_t>(at, longest_line)) + 1;
    return std::nullopt;
  }
  if (text.size() > longest_line) {
    fail(faults, "the line is longer than 1 MiB", "check that this is a text file with its line ends");
    return std::nullopt;
  }
  if (line_offset_ == 0 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

void LineReader::go_to(std::uint64_t offset, int line, std::vector<Fault>& faults) {
  if (failed_) return;
  line_ = line - 1;
  if (offset >= buffer_offset_ && offset <= buffer_offset_ + end_) {
    begin_ = std::size_t(offset - buffer_offset_);
    return;
  }
  begin_ = end_ = 0;
  buffer_offset_ = offset;
  at_end_ = false;
  if (::fseeko(stream_.get(), off_t(offset), SEEK_SET) != 0)
    fail(faults, "the file cannot be read again", "check the disk and the file");
}

}  // namespace bondstatic
