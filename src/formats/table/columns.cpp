#include "formats/table/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/row_fields.hpp"
#include "formats/table/edem_export.hpp"
#include "io/nearest_name.hpp"
#include "io/number_field.hpp"
#include "io/table_fields.hpp"

namespace bondstatic {
namespace {

constexpr int most_lines_above = 200;
constexpr std::size_t rows_between_progress = 1 << 16;

std::string_view without_comment_sign(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || line[begin] != '#') return line;
  const std::size_t after = line.find_first_not_of("# \t", begin);
  return after == std::string_view::npos ? std::string_view{} : line.substr(after);
}

std::vector<TableColumn> headings(std::string_view text, char separator, const Place& line,
                                  std::size_t offset) {
  std::vector<TableColumn> columns;
  std::vector<std::size_t> starts;
  if (append_field_starts(text, separator, 0, starts) != std::string_view::npos) return {};
  for (const std::size_t at : starts) {
    TableColumn column;
    column.heading = column_name(unquoted(field_at(text, at, separator)));
    column.place = {line.file, line.line, int(offset + at) + 1};
    columns.push_back(std::move(column));
  }
  // Lines of some exports end with a separator.
  if (columns.size() > 1 && columns.back().heading.text.empty()) columns.pop_back();
  return columns;
}

bool starts_with_number(std::string_view line) {
  std::vector<std::size_t> starts;
  const char separator = separator_of(line);
  append_field_starts(line, separator, 0, starts);
  return !starts.empty() && !std::isnan(number_field(field_at(line, starts[0], separator)));
}

}  // namespace

TableColumn* TableColumns::find(const Aliases& aliases, std::vector<Fault>& faults) {
  TableColumn* found = nullptr;
  for (TableColumn& column : columns) {
    if (column.wanted == Wanted::no || !among(column.heading.name, aliases)) continue;
    if (!found)
      found = &column;
    else
      faults.push_back(
          {column.place,
           fmt::format("columns \"{}\" and \"{}\" mean the same", found->heading.text, column.heading.text),
           "remove or rename one of them"});
  }
  return found;
}

bool TableColumns::has(const Aliases& aliases) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const TableColumn& column) { return among(column.heading.name, aliases); });
}

TableKind kind_of(const TableColumns& table) {
  if (table.has(columns::bond_a) && table.has(columns::bond_b)) return TableKind::bonds;
  const bool place = table.has(columns::x) && table.has(columns::y) && table.has(columns::z);
  return place ? TableKind::particles : TableKind::unknown;
}

void fault_unknown_kind(const TableColumns& table, std::vector<Fault>& faults) {
  const std::string example = "name the columns in a first line: x, y, z and id, radius, or a, b for bonds";
  if (table.columns.empty()) {
    faults.push_back(
        {{table.file, 1, 1}, "the table has no rows", "give a line of column names and a line for each row"});
    return;
  }
  std::vector<std::string> found;
  for (const TableColumn& column : table.columns) {
    if (!std::isnan(number_field(column.heading.text))) {
      faults.push_back({column.place,
                        fmt::format("the first line has the number {} where a column name must be",
                                    column.heading.text.substr(0, 40)),
                        example});
      return;
    }
    found.push_back(column.heading.text.substr(0, 40));
    if (found.size() == 40) break;
  }
  const std::vector<std::pair<const Aliases*, std::string>> axes{
      {&columns::x, "x"}, {&columns::y, "y"}, {&columns::z, "z"}};
  int there = 0;
  for (const auto& [aliases, name] : axes) there += table.has(*aliases);
  if (there == 0) {
    const bool one_end = table.has(columns::bond_a) != table.has(columns::bond_b);
    faults.push_back({table.header,
                      fmt::format("{}; found: {}",
                                  one_end ? "only one of the columns a, b that name a bond's particles"
                                          : "neither columns x, y, z of particles nor a, b of bonds",
                                  name_list(found)),
                      example});
    return;
  }
  for (const auto& [aliases, name] : axes)
    if (!table.has(*aliases))
      faults.push_back({table.header, fmt::format("no column {}; found: {}", name, name_list(found)),
                        fmt::format("name it one of: {}", name_list(*aliases))});
}

void append_field(TableColumn& column, std::string_view field, const std::function<Place()>& place,
                  LimitedFaults& faults) {
  std::string unpacked;
  if (field.starts_with('"')) field = unpacked = unquoted(field);
  const auto fault = [&](const std::string& what, const std::string& cure) {
    faults.add(place(), fmt::format("{} {}", column.heading.text, what), cure);
    column.numbers.push_back(not_given);
  };
  if (column.wanted == Wanted::word) {
    auto known = column.position_of_word.find(field);
    if (known == column.position_of_word.end()) {
      known = column.position_of_word.emplace(field, int(column.words.size())).first;
      column.words.emplace_back(field);
    }
    column.numbers.push_back(known->second);
    return;
  }
  if (column.wanted == Wanted::number_if_any) {
    const double number = number_field(field);
    column.numbers.push_back(std::isfinite(number) ? number : not_given);
    return;
  }
  if (field.empty() && column.wanted == Wanted::number_or_empty) {
    column.numbers.push_back(not_given);
    return;
  }
  const double value = number_field(field);
  if (field.empty())
    fault("is empty", "give a number in every row");
  else if (std::isnan(value))
    fault(fmt::format("= \"{}\" is not a number", shown(field)),
          field.find(',') != std::string_view::npos ? "write numbers with a decimal point, not a comma"
                                                    : "write a plain number such as 1.5e-3");
  else if (std::isinf(value))
    fault(fmt::format("= {} is not a finite double", shown(field)), "write a plain number such as 1.5e-3");
  else if (column.wanted == Wanted::positive && value <= 0)
    fault(fmt::format("= {} must be positive", shown(field)), "correct the row or leave it out");
  else if (column.wanted == Wanted::whole && !(value >= 0 && value < 9e15 && std::trunc(value) == value))
    fault(fmt::format("= {} must be a whole number, not negative, below 9e15", shown(field)),
          "number from 0 or 1 on");
  else
    column.numbers.push_back(value);
}

void read_table_rows(LineReader& reader, std::optional<std::string_view> line, char separator,
                     const ReadOptions& options, TableColumns& table, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  LimitedFaults shape(faults);
  std::vector<LimitedFaults> limited(table.columns.size(), LimitedFaults(faults));
  std::vector<std::size_t> starts;
  const std::size_t count = table.columns.size();
  if (!line) line = reader.next(faults);
  for (; line; line = reader.next(faults)) {
    starts.clear();
    const std::size_t open_quote = append_field_starts(*line, separator, 0, starts);
    if (starts.empty()) continue;
    if (open_quote != std::string_view::npos) {
      if (!add_open_quote(shape, reader.place(int(open_quote) + 1))) return;
      continue;
    }
    if (starts.size() == count + 1 && field_at(*line, starts.back(), separator).empty()) starts.pop_back();
    if (starts.size() != count) {
      if (!shape.add(reader.place(int(starts[0]) + 1),
                     fmt::format("the row has {} fields, the header {}", starts.size(), count),
                     "give every row one field for each column"))
        return;
      continue;
    }
    for (std::size_t c = 0; c < count; ++c)
      if (table.columns[c].wanted != Wanted::no)
        append_field(
            table.columns[c], field_at(*line, starts[c], separator),
            [&] { return reader.place(int(starts[c]) + 1); }, limited[c]);
    table.line.push_back(reader.line());
    if (options.progress && table.rows() % rows_between_progress == 0) options.progress(reader.part());
  }
  if (faults.size() == before && !reader.failed() && table.rows() == 0)
    faults.push_back({reader.place(), "the table has no rows", "give a line for each row below the header"});
}

std::optional<TableColumns> read_table_columns(const std::string& path, const ReadOptions& options,
                                               const WantColumn& want, const Place& named_at,
                                               std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  TableColumns table, first, comment;
  table.file = first.file = path;
  std::optional<std::string_view> row;
  std::string above;
  char separator = ',';
  while (const auto line = reader->next(faults)) {
    if (heads_edem_block(*line))
      return read_edem_blocks(*reader, std::string(*line), options, want, std::move(table.left_lines),
                              faults);
    const std::string_view text = without_comment_sign(*line);
    const bool is_comment = text.size() != line->size();
    TableColumns here;
    separator = separator_of(text);
    here.columns = headings(text, separator, reader->place(), std::size_t(text.data() - line->data()));
    here.header = here.columns.empty() ? reader->place() : here.columns[0].place;
    if (here.columns.empty()) continue;
    if (kind_of(here) != TableKind::unknown) {
      (is_comment ? comment : table).columns = std::move(here.columns);
      (is_comment ? comment : table).header = here.header;
      if (!is_comment) break;
      continue;
    }
    if (is_comment) continue;
    if (!comment.columns.empty() && starts_with_number(*line)) {
      table.columns = std::move(comment.columns);
      table.header = comment.header;
      row = line;
      break;
    }
    if (first.columns.empty()) {
      first.columns = std::move(here.columns);
      first.header = here.header;
    }
    table.left_lines.emplace_back(line->substr(0, 80));
    if (reader->line() >= most_lines_above) break;
  }
  if (reader->failed()) return std::nullopt;
  if (table.columns.empty()) {
    fault_unknown_kind(first, faults);
    return std::nullopt;
  }
  const TableKind kind = kind_of(table);
  for (TableColumn& column : table.columns) column.wanted = want(column.heading, kind);
  read_table_rows(*reader, row, separator, options, table, faults);
  if (faults.size() != before) return std::nullopt;
  return table;
}

}  // namespace bondstatic
