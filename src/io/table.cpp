#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/table_fields.hpp"
#include "io/text_file.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

/// NaN where the field is no number, infinite where it is out of range.
double number_of(std::string_view field) {
  const std::string plain = unquoted(field);
  const char *begin = plain.data(), *end = begin + plain.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (stop != end || begin == end) return std::numeric_limits<double>::quiet_NaN();
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  return error == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string number_cure(std::string_view field) {
  if (field.find(',') != std::string_view::npos) return "write numbers with a decimal point, not a comma";
  return "write a plain number such as 1.5e-3; units are not understood here";
}

/// Adds a fault unless twenty are there already; false then, after saying that there is more.
class Limited {
 public:
  explicit Limited(std::vector<Fault>& faults) : faults_(faults) {}
  bool add(const Place& place, const std::string& message, const std::string& cure) {
    if (++count_ <= most_faults) faults_.push_back({place, message, cure});
    if (count_ == most_faults + 1)
      faults_.push_back({place, "more such faults follow from here on", "cure those above first"});
    return count_ <= most_faults;
  }

 private:
  std::vector<Fault>& faults_;
  int count_ = 0;
};

}  // namespace

std::optional<Table> Table::parse(std::string text, const std::string& file, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  Limited limited(faults);
  Table table;
  table.text_ = std::move(text);
  table.file_ = file;
  const std::string_view all = table.text_;
  int line_number = 0;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    std::string_view line = all.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_number;
    if (table.names_.empty()) table.separator_ = separator_of(line);
    const FieldStarts starts = field_starts(line, table.separator_);
    const auto place = [&](std::size_t at) { return Place{file, line_number, int(at) + 1}; };
    if (starts.open_quote != std::string_view::npos) {
      if (!limited.add(place(starts.open_quote), "a quote opens here and is not closed before the separator",
                       "close it, or leave the quotes out"))
        break;
    } else if (starts.begins.empty()) {
      // nothing but blanks or a comment
    } else if (table.names_.empty()) {
      table.header_line_ = line_number;
      for (const std::size_t at : starts.begins) {
        const std::string name = unquoted(field_at(line, at, table.separator_));
        if (!std::isnan(number_of(name)) && faults.size() == before)
          faults.push_back({place(at),
                            fmt::format("the first line has the number {} where a column name must be", name),
                            "name the columns in a first line without #, e.g. id,x,y,z,radius"});
        const bool twice = std::any_of(table.names_.begin(), table.names_.end(),
                                       [&](const std::string& other) { return lower(other) == lower(name); });
        if (twice && !name.empty() && faults.size() == before)
          faults.push_back(
              {place(at), fmt::format("column \"{}\" is there twice", name), "remove or rename one of them"});
        table.names_.push_back(name);
        table.name_columns_.push_back(int(at) + 1);
      }
      if (faults.size() != before) return std::nullopt;
    } else if (starts.begins.size() != table.names_.size()) {
      if (!limited.add(
              place(starts.begins.front()),
              fmt::format("the row has {} fields, the header {}", starts.begins.size(), table.names_.size()),
              "give every row one field for each column"))
        break;
    } else {
      table.row_begin_.push_back(begin);
      table.row_line_.push_back(line_number);
      for (const std::size_t at : starts.begins) table.field_begin_.push_back(begin + at);
    }
    begin = end + 1;
  }
  if (faults.size() == before && table.rows() == 0)
    faults.push_back({{file, std::max(line_number, 1), 1},
                      "the table has no rows",
                      "give a line of column names and a line for each row"});
  if (faults.size() != before) return std::nullopt;
  return table;
}

int Table::find(std::span<const std::string> aliases, std::vector<Fault>& faults) const {
  int found = -1;
  for (std::size_t column = 0; column < names_.size(); ++column) {
    if (std::find(aliases.begin(), aliases.end(), lower(names_[column])) == aliases.end()) continue;
    if (found < 0)
      found = int(column);
    else
      faults.push_back(
          {place(-1, int(column)),
           fmt::format("columns \"{}\" and \"{}\" mean the same", names_[std::size_t(found)], names_[column]),
           "remove or rename one of them"});
  }
  return found;
}

std::string_view Table::field(Index row, int column) const {
  const std::string_view all = text_;
  const std::size_t begin = field_begin_[std::size_t(row) * names_.size() + std::size_t(column)];
  const std::size_t end = std::min(all.find('\n', begin), all.size());
  return field_at(all.substr(0, end), begin, separator_);
}

std::vector<double> Table::numbers(int column, bool may_be_empty, std::vector<Fault>& faults) const {
  Limited limited(faults);
  std::vector<double> values;
  values.reserve(row_begin_.size());
  for (Index row = 0; row < rows(); ++row) {
    const std::string_view text = field(row, column);
    const double value = number_of(text);
    values.push_back(value);
    if (std::isfinite(value) || (text.empty() && may_be_empty)) continue;
    const std::string& name = names_[std::size_t(column)];
    const std::string what = text.empty() ? fmt::format("{} is empty", name)
                             : std::isnan(value)
                                 ? fmt::format("{} = \"{}\" is not a number", name, text.substr(0, 40))
                                 : fmt::format("{} = {} is not a finite double", name, text.substr(0, 40));
    if (!limited.add(place(row, column), what, number_cure(text))) break;
  }
  values.resize(row_begin_.size(), std::numeric_limits<double>::quiet_NaN());
  return values;
}

std::vector<Index> Table::whole_numbers(int column, std::vector<Fault>& faults) const {
  const std::size_t before = faults.size();
  const std::vector<double> values = numbers(column, false, faults);
  std::vector<Index> whole(values.size());
  if (faults.size() != before) return whole;
  Limited limited(faults);
  for (Index row = 0; row < rows(); ++row) {
    const double value = values[std::size_t(row)];
    if (value >= 0 && value < 9e15 && std::trunc(value) == value) {
      whole[std::size_t(row)] = Index(value);
    } else if (!limited.add(place(row, column),
                            fmt::format("{} = {} must be a whole number, not negative, below 9e15",
                                        names_[std::size_t(column)], field(row, column)),
                            "number from 0 or 1 on")) {
      break;
    }
  }
  return whole;
}

std::vector<std::string> Table::texts(int column) const {
  std::vector<std::string> out;
  for (Index row = 0; row < rows(); ++row) out.push_back(unquoted(field(row, column)));
  return out;
}

Place Table::place(Index row, int column) const {
  if (row < 0) return {file_, header_line_, column < 0 ? 1 : name_columns_[std::size_t(column)]};
  const std::size_t field = std::size_t(row) * names_.size() + std::size_t(std::max(column, 0));
  return {file_, row_line_[std::size_t(row)], int(field_begin_[field] - row_begin_[std::size_t(row)]) + 1};
}

std::optional<Table> read_table(const std::string& path, const Place& named_at, std::vector<Fault>& faults) {
  std::optional<std::string> text = read_text_file(path, named_at, faults);
  if (!text) return std::nullopt;
  return Table::parse(std::move(*text), path, faults);
}

}  // namespace bondstatic
