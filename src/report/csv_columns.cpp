#include "report/csv_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

#include "io/nearest_name.hpp"
#include "io/text_file.hpp"

namespace bondstatic {

namespace {

constexpr const char* cure = "let the command that made it write it anew";

/// The names in the first line, and how long that line is. A name may hold any character but a line end.
std::vector<std::string> header_of(const std::string& text, std::size_t& length) {
  std::vector<std::string> names(1);
  bool quoted = false;
  for (length = 0; length < text.size(); ++length) {
    const char c = text[length];
    if (c == '\n') break;
    if (c == '"') {
      const bool again = quoted && length + 1 < text.size() && text[length + 1] == '"';
      if (again) names.back() += text[++length];
      if (!again) quoted = !quoted;
    } else if (c == ',' && !quoted) {
      names.emplace_back();
    } else if (c != '\r') {
      names.back() += c;
    }
  }
  return names;
}

/// A header that Table takes, whatever the columns are called: names that differ, are no numbers and have
/// nothing in them that separates or begins a comment.
std::string plain_header(const std::vector<std::string>& names) {
  std::set<std::string> taken;
  std::string header;
  for (std::size_t c = 0; c < names.size(); ++c) {
    std::string plain, lower;
    for (const unsigned char letter : names[c]) {
      if (std::isalnum(letter) || letter == '_' || letter == '.') plain += char(letter);
      lower += char(std::tolower(letter));
    }
    const bool fits = plain == names[c] && !plain.empty() && std::isalpha((unsigned char)plain.front()) &&
                      lower != "nan" && lower != "inf" && lower != "infinity" && taken.insert(lower).second;
    header += (c == 0 ? "" : ",") + (fits ? plain : fmt::format("column_{}", c + 1));
  }
  return header;
}

}  // namespace

std::optional<CsvColumns> CsvColumns::read(const std::string& file) {
  std::error_code not_there;
  if (!std::filesystem::exists(file, not_there)) return std::nullopt;
  std::vector<Fault> faults;
  auto text = read_text_file(file, {}, faults);
  if (!text) throw InputError(std::move(faults));
  CsvColumns columns;
  columns.file_ = file;
  std::size_t length = 0;
  columns.names_ = header_of(*text, length);
  if (columns.names_ == std::vector<std::string>{""})
    throw InputError({{{file, 1, 1}, "the first line is empty where it must name the columns", cure}});
  if (text->find_first_not_of(" \t\r\n", length) == std::string::npos) return columns;
  text->replace(0, length, plain_header(columns.names_));
  columns.table_ = Table::parse(std::move(*text), file, faults);
  if (!columns.table_) throw InputError(std::move(faults));
  return columns;
}

int CsvColumns::find(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : int(found - names_.begin());
}

int CsvColumns::required(const std::string& name) const {
  const int column = find(name);
  if (column < 0)
    throw InputError(
        {{{file_, 1, 1}, fmt::format("there is no column {}, but {}", name, name_list(names_)), cure}});
  return column;
}

std::vector<double> CsvColumns::numbers(int column) const {
  if (!table_) return {};
  std::vector<Fault> faults;
  auto values = table_->numbers(column, true, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  return values;
}

std::vector<Index> CsvColumns::whole_numbers(int column) const {
  if (!table_) return {};
  std::vector<Fault> faults;
  auto values = table_->whole_numbers(column, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  return values;
}

std::vector<std::string> CsvColumns::texts(int column) const {
  return table_ ? table_->texts(column) : std::vector<std::string>{};
}

std::vector<double> CsvColumns::numbers(const std::string& name) const {
  return numbers(required(name));
}

std::vector<Index> CsvColumns::whole_numbers(const std::string& name) const {
  return whole_numbers(required(name));
}

std::vector<std::string> CsvColumns::texts(const std::string& name) const {
  return texts(required(name));
}

}  // namespace bondstatic
