#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/number_field.hpp"
#include "io/table_fields.hpp"
#include "io/text_file.hpp"

namespace bondstatic {
namespace {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

double number_of(std::string_view field) {
  return field.starts_with('"') ? number_field(unquoted(field)) : number_field(field);
}

std::string number_cure(std::string_view field) {
  if (field.find(',') != std::string_view::npos) return "write numbers with a decimal point, not a comma";
  return "write a plain number such as 1.5e-3; units are not understood here";
}

}  // namespace

std::optional<Table> Table::parse(std::string text, const std::string& file, std::vector<Fault>& faults,
                                  int threads) {
  const std::size_t before = faults.size();
  LimitedFaults limited(faults);
  Table table;
  table.text_ = std::move(text);
  table.file_ = file;
  table.threads_ = threads;
  const std::string_view all = table.text_;
  int line_number = 0;
  std::size_t begin = 0;
  while (begin < all.size() && table.names_.empty()) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    std::string_view line = all.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_number;
    table.separator_ = separator_of(line);
    std::vector<std::size_t> starts;
    const std::size_t open_quote = append_field_starts(line, table.separator_, 0, starts);
    if (open_quote != std::string_view::npos) {
      if (!add_open_quote(limited, {file, line_number, int(open_quote) + 1})) break;
    } else if (!starts.empty()) {
      table.name_columns(line, line_number, starts, faults);
      if (faults.size() != before) return std::nullopt;
    }
    begin = end + 1;
  }
  if (!table.names_.empty())
    line_number = find_rows(all, begin, line_number, {file, table.separator_, table.names_.size()}, limited,
                            table.rows_, threads);
  if (faults.size() == before && table.rows() == 0)
    faults.push_back({{file, std::max(line_number, 1), 1},
                      "the table has no rows",
                      "give a line of column names and a line for each row"});
  if (faults.size() != before) return std::nullopt;
  return table;
}

void Table::name_columns(std::string_view line, int line_number, const std::vector<std::size_t>& starts,
                         std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  header_line_ = line_number;
  for (const std::size_t at : starts) {
    const Place here{file_, line_number, int(at) + 1};
    const std::string name = unquoted(field_at(line, at, separator_));
    if (!std::isnan(number_of(name)) && faults.size() == before)
      faults.push_back({here,
                        fmt::format("the first line has the number {} where a column name must be", name),
                        "name the columns in a first line without #, e.g. id,x,y,z,radius"});
    const bool twice = std::any_of(names_.begin(), names_.end(),
                                   [&](const std::string& other) { return lower(other) == lower(name); });
    if (twice && !name.empty() && faults.size() == before)
      faults.push_back(
          {here, fmt::format("column \"{}\" is there twice", name), "remove or rename one of them"});
    names_.push_back(name);
    name_columns_.push_back(int(at) + 1);
  }
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
  const std::size_t at = std::size_t(row) * names_.size() + std::size_t(column);
  const std::size_t begin = rows_.field_begin[at];
  // A field ends before the next one of its row begins, the last of the row with its line.
  const bool last = std::size_t(column) + 1 == names_.size();
  const std::size_t end = last ? std::min(all.find('\n', begin), all.size()) : rows_.field_begin[at + 1];
  return field_at(all.substr(0, end), begin, separator_);
}

std::string Table::number_fault(std::string_view text, double value, int column) const {
  const std::string& name = names_[std::size_t(column)];
  if (text.empty()) return fmt::format("{} is empty", name);
  if (std::isnan(value)) return fmt::format("{} = \"{}\" is not a number", name, text.substr(0, 40));
  return fmt::format("{} = {} is not a finite double", name, text.substr(0, 40));
}

std::vector<double> Table::numbers(int column, bool may_be_empty, std::vector<Fault>& faults) const {
  std::vector<double> values(rows_.row_begin.size());
  constexpr Index piece = 1 << 14;
  const Index pieces = (rows() + piece - 1) / piece;
  const int threads = int(std::clamp<Index>(pieces, 1, std::max(1, threads_)));
  std::vector<std::vector<Index>> wrong(static_cast<std::size_t>(pieces));  // rows, so many as may be told
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (Index i = 0; i < pieces; ++i) {
    auto& here = wrong[std::size_t(i)];
    for (Index row = i * piece; row < std::min(rows(), (i + 1) * piece); ++row) {
      const std::string_view text = field(row, column);
      const double value = values[std::size_t(row)] = number_of(text);
      if (!std::isfinite(value) && !(text.empty() && may_be_empty) && here.size() <= most_table_faults)
        here.push_back(row);
    }
  }
  LimitedFaults limited(faults);
  for (const auto& here : wrong)
    for (const Index row : here) {
      const std::string_view text = field(row, column);
      if (limited.add(place(row, column), number_fault(text, values[std::size_t(row)], column),
                      number_cure(text)))
        continue;
      // What follows is not told, hence not to be taken for sound either.
      std::fill(values.begin() + row + 1, values.end(), std::numeric_limits<double>::quiet_NaN());
      return values;
    }
  return values;
}

std::vector<Index> Table::whole_numbers(int column, std::vector<Fault>& faults) const {
  const std::size_t before = faults.size();
  const std::vector<double> values = numbers(column, false, faults);
  std::vector<Index> whole(values.size());
  if (faults.size() != before) return whole;
  LimitedFaults limited(faults);
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
  const auto [line, at] = line_and_column(row, column);
  return {file_, line, at};
}

std::pair<int, int> Table::line_and_column(Index row, int column) const {
  const std::size_t field = std::size_t(row) * names_.size() + std::size_t(std::max(column, 0));
  return {rows_.row_line[std::size_t(row)],
          int(rows_.field_begin[field] - rows_.row_begin[std::size_t(row)]) + 1};
}

std::optional<Table> read_table(const std::string& path, const Place& named_at, std::vector<Fault>& faults,
                                int threads) {
  std::optional<std::string> text = read_text_file(path, named_at, faults);
  if (!text) return std::nullopt;
  return Table::parse(std::move(*text), path, faults, threads);
}

}  // namespace bondstatic
