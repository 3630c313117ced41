// Reading a whole text file, with a fault instead of an exception where that cannot be done.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// The text of a file, without a byte order mark. Missing files, folders, devices, unreadable and binary
/// files (with NUL bytes) are faults, appended with the place that names the file.
std::optional<std::string> read_text_file(const std::string& path, const Place& named_at,
                                          std::vector<Fault>& faults);

}  // namespace bondstatic
