// What the terminal gets: tables, and emphasis where it can show it.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace bondstatic {

/// A terminal that shows control sequences, and a user who did not ask for none (NO_COLOR).
bool shows_style(std::FILE* stream);

std::string bold(const std::string& text, std::FILE* stream);
std::string red(const std::string& text, std::FILE* stream);

/// Columns as wide as their widest cell, two blanks apart, `indent` blanks before each line. The last column
/// is not padded. `right` columns are flush right (numbers).
struct TextTable {
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> right;
};
std::string to_text(const TextTable& table, int indent);

/// Lines of at most 100 characters, broken at blanks; all but the first are indented.
std::string wrapped(const std::string& text, int indent);

/// "1.23 s", "45 ms"
std::string seconds_text(double seconds);
/// "1.2 GB", in powers of ten
std::string bytes_text(double bytes);

}  // namespace bondstatic
