#include "formats/table/edem_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/number_field.hpp"

namespace bondstatic {
namespace {

constexpr std::string_view separators = ",;\t ";
constexpr int lines_between_progress = 256;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
  while (!text.empty() && separators.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  return text;
}

/// Where "Q07 :" begins from `from` on, at the beginning of the line or after a separator; npos: nowhere.
std::size_t find_query(std::string_view line, std::size_t from) {
  for (std::size_t at = from; at < line.size(); ++at) {
    if (line[at] != 'Q' || (at > 0 && separators.find(line[at - 1]) == std::string_view::npos)) continue;
    std::size_t end = at + 1;
    while (end < line.size() && is_digit(line[end])) ++end;
    if (end == at + 1) continue;
    while (end < line.size() && line[end] == ' ') ++end;
    if (end < line.size() && line[end] == ':') return at;
  }
  return std::string_view::npos;
}

bool is_time(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.starts_with("TIME:") || text.starts_with("TIME :") || text.starts_with("Time:");
}

/// The fields of a row; separators other than blanks keep empty fields.
void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const std::size_t at = line.find_first_of(",;\t");
  if (at == std::string_view::npos) {
    split_at_blanks(line, fields);
    return;
  }
  const char separator = line[at];
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
}

class BlockReader {
 public:
  BlockReader(LineReader& reader, const ReadOptions& options, const WantColumn& want,
              std::vector<Fault>& faults)
      : reader_(reader), options_(options), want_(want), faults_(faults), before_(faults.size()) {
    limited_.emplace(faults);
  }

  void read(std::string_view line) {
    if (trimmed(line) == "EXTRACTED DATA")
      forget_preface();
    else if (trimmed(line).empty())
      below_headings_.clear();
    else if (is_time(line))
      begin_block(line);
    else if (find_query(line, 0) == std::string_view::npos)
      read_row(line);
    else if (wanted_)
      read_queries(line);
    if (options_.progress && reader_.line() % lines_between_progress == 0) options_.progress(reader_.part());
  }

  int blocks() const { return blocks_; }
  TableColumns block;

 private:
  /// The preface may list the queries of the configuration, too.
  void forget_preface() {
    faults_.resize(before_);
    limited_.emplace(faults_);
    block = {};
    queries_.clear();
    below_headings_.clear();
    blocks_ = 0;
    wanted_ = true;
  }

  void begin_block(std::string_view line) {
    const std::string_view text = trimmed(line);
    const std::string_view number = trimmed(text.substr(text.find(':') + 1));
    const double time = number_field(number);
    if (!std::isfinite(time))
      limited_->add(reader_.place(), fmt::format("TIME = \"{}\" is not a number", number.substr(0, 40)),
                    "EDEM writes the time of a block as TIME: 0.25");
    start(time);
  }

  void start(double time) {
    ++blocks_;
    wanted_ = !options_.step || *options_.step == blocks_;
    below_headings_.clear();
    if (!wanted_) return;
    block = {};
    queries_.clear();
    block.file = reader_.file();
    block.header = reader_.place();
    block.edem = true;
    block.time = time;
  }

  /// One query with its values, or the headings of columns.
  void read_queries(std::string_view line) {
    if (blocks_ == 0) start(not_given);  // exported without times
    below_headings_.clear();
    rows_below_ = 0;
    std::vector<std::size_t> at;
    for (std::size_t q = find_query(line, 0); q != std::string_view::npos; q = find_query(line, q + 1))
      at.push_back(q);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const std::size_t end = i + 1 < at.size() ? at[i + 1] : line.size();
      const std::string_view part = trimmed(line.substr(at[i], end - at[i]));
      const std::size_t number_end = part.find(':'), last = part.rfind(':');
      const std::string_view label = last > number_end ? part.substr(0, last) : part;
      const std::string_view values = last > number_end ? trimmed(part.substr(last + 1)) : std::string_view{};
      TableColumn column;
      column.heading = column_name(label);
      column.place = reader_.place(int(at[i]) + 1);
      column.wanted = want_(column.heading, TableKind::unknown);
      if (!queries_.emplace(column.heading.name, column.heading.unit).second)
        limited_->add(column.place,
                      fmt::format("query \"{}\" is there twice in a block", column.heading.text),
                      "export each particle type into a file of its own, and give all of the files");
      if (column.wanted != Wanted::no && values != "no data") read_values(values, column);
      block.columns.push_back(std::move(column));
      if (at.size() == 1 && !values.empty()) return;
      below_headings_.push_back(block.columns.size() - 1);
    }
  }

  void read_values(std::string_view values, TableColumn& column) {
    split_values(values);
    for (const std::string_view field : fields_)
      append_field(
          column, field, [&] { return column.place; }, *limited_);
  }

  void split_values(std::string_view values) {
    fields_.clear();
    for (std::size_t at = values.find_first_not_of(separators); at != std::string_view::npos;) {
      const std::size_t end = std::min(values.find_first_of(separators, at), values.size());
      fields_.push_back(values.substr(at, end - at));
      at = values.find_first_not_of(separators, end);
    }
  }

  void read_row(std::string_view line) {
    if (!wanted_ && blocks_ > 0) return;
    if (below_headings_.empty()) {
      limited_->add(reader_.place(), "a line that is neither a time nor a query nor values below queries",
                    "export positions and properties of all particles, without averages and totals");
      return;
    }
    split(line, fields_);
    const std::size_t count = below_headings_.size();
    if (fields_.size() > count && fields_.front().empty()) fields_.erase(fields_.begin());
    while (fields_.size() > count && fields_.back().empty()) fields_.pop_back();
    if (fields_.size() > count) {
      limited_->add(reader_.place(),
                    fmt::format("the row has {} values below {} queries", fields_.size(), count),
                    "export with one column for each query");
      return;
    }
    block.line.push_back(reader_.line());
    // A query of one value, as the number of particles, has only a first row.
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      TableColumn& column = block.columns[below_headings_[i]];
      if (column.wanted == Wanted::no || (fields_[i].empty() && column.wanted != Wanted::number_or_empty))
        continue;
      if (column.numbers.size() < rows_below_)
        limited_->add(reader_.place(),
                      fmt::format("\"{}\" has a value below an empty field", column.heading.text),
                      "export all queries of the same particles");
      append_field(
          column, fields_[i], [&] { return reader_.place(); }, *limited_);
    }
    ++rows_below_;
  }

  LineReader& reader_;
  const ReadOptions& options_;
  const WantColumn& want_;
  std::vector<Fault>& faults_;
  std::size_t before_;
  std::optional<LimitedFaults> limited_;
  std::vector<std::string_view> fields_;
  std::set<std::pair<std::string, std::string>> queries_;  // of the block: name and unit
  std::vector<std::size_t> below_headings_;                // columns that the rows here belong to
  std::size_t rows_below_ = 0;
  int blocks_ = 0;
  bool wanted_ = true;
};

}  // namespace

bool heads_edem_block(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(separators);
  return begin != std::string_view::npos && (is_time(line) || find_query(line, begin) == begin);
}

std::optional<TableColumns> read_edem_blocks(LineReader& reader, std::string line, const ReadOptions& options,
                                             const WantColumn& want, std::vector<std::string> left_lines,
                                             std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  BlockReader blocks(reader, options, want, faults);
  blocks.read(line);
  while (const auto next = reader.next(faults)) blocks.read(*next);
  if (reader.failed() && !faults.empty())
    faults.back().cure += "; EDEM's option \"Output Data in Columns\" gives short lines";
  if (options.step && (*options.step < 1 || *options.step > blocks.blocks()))
    faults.push_back(
        {reader.place(),
         fmt::format("there is no time {} in the export, which has {}", *options.step, blocks.blocks()),
         "times are counted from 1; leave the step out for the last"});
  if (faults.size() != before) return std::nullopt;

  TableColumns table = std::move(blocks.block);
  table.left_lines = std::move(left_lines);
  const TableColumn* longest = nullptr;
  for (const TableColumn& column : table.columns)
    if (column.wanted != Wanted::no && (!longest || column.numbers.size() > longest->numbers.size()))
      longest = &column;
  const std::size_t rows = longest ? longest->numbers.size() : 0;
  for (TableColumn& column : table.columns) {
    if (column.wanted == Wanted::no || column.numbers.size() == rows) continue;
    if (column.wanted == Wanted::number_or_empty && column.numbers.empty())
      column.numbers.assign(rows, not_given);
    else
      faults.push_back({column.place,
                        fmt::format("query \"{}\" has {} values, \"{}\" {}", column.heading.text,
                                    column.numbers.size(), longest->heading.text, rows),
                        "export all queries of the same particles at the same times"});
  }
  if (rows == 0)
    faults.push_back(
        {reader.place(), "the block has no values", "choose a time at which there are particles"});
  if (faults.size() != before) return std::nullopt;
  if (table.line.size() != rows) table.line.assign(rows, longest->place.line);  // values stand in one line
  return table;
}

}  // namespace bondstatic
