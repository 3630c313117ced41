#include "io/archive.hpp"

#include <fmt/format.h>

#include <cstring>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

std::string magic(const ArchiveFormat& format) {
  return "bondstatic " + format.name + "\n";
}

template <class T>
T taken(std::string_view& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

}  // namespace

Archive::Archive(const ArchiveFormat& format) : mode_(Mode::writing), format_(format) {
  written_ = magic(format);
  written_.append(reinterpret_cast<const char*>(&format.version), sizeof format.version);
  written_.resize(header_size());
}

Archive::Archive(const ArchiveFormat& format, std::string_view file, std::string shown)
    : mode_(Mode::reading), format_(format), left_(file), shown_(std::move(shown)) {
  const std::string start = magic(format);
  if (!file.starts_with(start))
    throw Error(ExitCode::invalid_input, fmt::format("{0}: is no {1} of this program\n"
                                                     "    cure: check the path, or move the file away",
                                                     shown_, format.name));
  left_.remove_prefix(start.size());
  if (left_.size() < sizeof format.version) damaged("it ends within its header");
  const auto version = taken<std::uint32_t>(left_);
  if (version != format.version)
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: was written by version {} of the {} format; this program reads version {}\n"
                            "    cure: go on with the program that wrote it, or move the file away",
                            shown_, version, format.name, format.version));
  if (file.size() < header_size()) damaged("it ends within its header");
  const auto size = taken<std::uint64_t>(left_), sum = taken<std::uint64_t>(left_);
  if (size != left_.size())
    damaged(fmt::format("it should hold {} bytes after its header and holds {}", size, left_.size()));
  if (sum != bondstatic::checksum(left_)) damaged("its checksum is not that of its content");
}

std::size_t Archive::header_size() const {
  return magic(format_).size() + sizeof format_.version + 2 * sizeof(std::uint64_t);
}

void Archive::damaged(const std::string& reason) const {
  throw Error(ExitCode::invalid_input,
              fmt::format("{}: is damaged: {}\n"
                          "    cure: put a sound copy in its place, or move it away and start anew",
                          shown_, reason));
}

void Archive::bytes(void* data, std::size_t size) {
  if (size == 0) return;
  const std::string_view view(static_cast<const char*>(data), size);
  if (mode_ == Mode::hashing) {
    checksum_.add(view);
  } else if (mode_ == Mode::writing) {
    written_.append(view);
  } else {
    if (size > left_.size()) damaged("it ends before all is read");
    std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
}

std::size_t Archive::length(std::size_t size, std::size_t least) {
  std::uint64_t value = size;
  bytes(&value, sizeof value);
  if (reading() && value > left_.size() / least)
    damaged(fmt::format("a length of {} is more than it holds", value));
  return value;
}

std::string Archive::finish() {
  const std::uint64_t size = written_.size() - header_size();
  const std::uint64_t sum = bondstatic::checksum(std::string_view(written_).substr(header_size()));
  char* place = written_.data() + header_size() - 2 * sizeof size;
  std::memcpy(place, &size, sizeof size);
  std::memcpy(place + sizeof size, &sum, sizeof sum);
  return std::move(written_);
}

void Archive::expect_end() const {
  if (!left_.empty()) damaged(fmt::format("{} bytes are left over", left_.size()));
}

}  // namespace bondstatic
