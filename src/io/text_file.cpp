#include "io/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace bondstatic {

namespace {

Fault file_fault(const std::string& path, const Place& named_at, const std::string& what,
                 const std::string& cure) {
  return {named_at, "file \"" + path + "\" " + what, cure};
}

}  // namespace

TextStream open_text_file(const std::string& path, const Place& named_at, std::vector<Fault>& faults) {
  const auto fail = [&](const std::string& what, const std::string& cure) {
    faults.push_back(file_fault(path, named_at, what, cure));
    return TextStream(nullptr, &std::fclose);
  };
  if (path.empty() || path.find('\0') != std::string::npos)
    return fail("is no file name", "give the path of a text file");
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return fail("does not exist", "check the path; paths in a case file are relative to that file");
  if (std::filesystem::is_directory(status)) return fail("is a folder", "give the path of a text file");
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
    return fail("is a device", "give the path of a text file");
  TextStream stream(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!stream) return fail(std::string("cannot be opened: ") + std::strerror(errno), "check its permissions");
  return stream;
}

std::optional<std::string> read_text_file(const std::string& path, const Place& named_at,
                                          std::vector<Fault>& faults) {
  const auto fail = [&](const std::string& what, const std::string& cure) {
    faults.push_back(file_fault(path, named_at, what, cure));
    return std::nullopt;
  };
  const TextStream stream = open_text_file(path, named_at, faults);
  if (!stream) return std::nullopt;
  std::string text;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);  // an error for what is no plain file
  if (!error) text.reserve(size);
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get()))
    text.append(buffer, count);
  if (std::ferror(stream.get())) return fail("cannot be read", "check the disk and the file");
  if (text.find('\0') != std::string::npos)
    return fail("is binary, not text", "save it as plain UTF-8 text (UTF-16 is not understood)");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
  return text;
}

}  // namespace bondstatic
