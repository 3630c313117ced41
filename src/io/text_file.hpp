// Reading a whole text file, with a fault instead of an exception where that cannot be done.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

using TextStream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file opened to be read from its beginning. Missing files, folders, devices and unreadable files are
/// faults, appended with the place that names the file; null then.
TextStream open_text_file(const std::string& path, const Place& named_at, std::vector<Fault>& faults);

/// The text of a file, without a byte order mark. Missing files, folders, devices, unreadable and binary
/// files (with NUL bytes) are faults, appended with the place that names the file.
std::optional<std::string> read_text_file(const std::string& path, const Place& named_at,
                                          std::vector<Fault>& faults);

}  // namespace bondstatic
