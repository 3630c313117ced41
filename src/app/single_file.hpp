// A command's answer as one file of a folder.
#pragma once

#include <string>

namespace bondstatic {

/// Throws Error (invalid_input) where write_single_file() could not write; worth calling before long work.
void check_single_file(const std::string& folder, const std::string& name);

/// Whole or not at all, and after a signal as it was; replaces the file of an earlier run.
void write_single_file(const std::string& folder, const std::string& name, const std::string& content);

}  // namespace bondstatic
