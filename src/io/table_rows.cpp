#include "io/table_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/table_fields.hpp"

namespace bondstatic {
namespace {

constexpr std::size_t piece_size = std::size_t(1) << 20;

struct Piece {
  std::size_t begin = 0, end = 0;
  int lines = 0;
  TableRows rows;             // lines counted within the piece
  std::vector<Fault> faults;  // likewise
};

/// Pieces that end with a line.
std::vector<Piece> cut(std::string_view text, std::size_t begin) {
  std::vector<Piece> pieces;
  while (begin < text.size()) {
    const std::size_t line_end = text.find('\n', std::min(begin + piece_size, text.size()));
    const std::size_t end = line_end == std::string_view::npos ? text.size() : line_end + 1;
    pieces.emplace_back().begin = begin;
    pieces.back().end = end;
    begin = end;
  }
  return pieces;
}

void find_rows(std::string_view text, const TableShape& shape, Piece& piece) {
  LimitedFaults limited(piece.faults);
  for (std::size_t begin = piece.begin; begin < piece.end;) {
    const std::size_t end = std::min(text.find('\n', begin), piece.end);
    std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++piece.lines;
    auto& fields = piece.rows.field_begin;
    const std::size_t before = fields.size();
    const std::size_t open_quote = append_field_starts(line, shape.separator, begin, fields);
    const std::size_t found = fields.size() - before;
    const auto place = [&](std::size_t at) { return Place{shape.file, piece.lines, int(at - begin) + 1}; };
    bool go_on = true;
    if (open_quote != std::string_view::npos) {
      go_on = add_open_quote(limited, place(open_quote));
    } else if (found > 0 && found != shape.columns) {
      go_on = limited.add(place(fields[before]),
                          fmt::format("the row has {} fields, the header {}", found, shape.columns),
                          "give every row one field for each column");
    } else if (found > 0) {
      piece.rows.row_begin.push_back(begin);
      piece.rows.row_line.push_back(piece.lines);
      begin = end + 1;
      continue;
    }
    fields.resize(before);
    if (!go_on) return;
    begin = end + 1;
  }
}

template <class T>
void place_in(std::vector<T>& all, std::size_t at, const std::vector<T>& part) {
  std::copy(part.begin(), part.end(), all.begin() + std::ptrdiff_t(at));
}

}  // namespace

bool LimitedFaults::add(const Place& place, const std::string& message, const std::string& cure) {
  if (++count_ <= most_table_faults) faults_.push_back({place, message, cure});
  if (count_ == most_table_faults + 1)
    faults_.push_back({place, "more such faults follow from here on", "cure those above first"});
  return count_ <= most_table_faults;
}

bool add_open_quote(LimitedFaults& faults, const Place& place) {
  return faults.add(place, "a quote opens here and is not closed before the separator",
                    "close it, or leave the quotes out");
}

int find_rows(std::string_view text, std::size_t begin, int first_line, const TableShape& shape,
              LimitedFaults& faults, TableRows& rows, int threads) {
  std::vector<Piece> pieces = cut(text, begin);
  const Index count = Index(pieces.size());
  threads = int(std::clamp<Index>(count, 1, std::max(1, threads)));
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (Index i = 0; i < count; ++i) find_rows(text, shape, pieces[std::size_t(i)]);

  std::vector<std::size_t> row_at(pieces.size() + 1), field_at(pieces.size() + 1);
  int lines = first_line;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    for (Fault& fault : piece.faults) {
      fault.place.line += lines;
      if (!faults.add(fault.place, fault.message, fault.cure)) return lines + piece.lines;
    }
    for (int& line : piece.rows.row_line) line += lines;
    lines += piece.lines;
    row_at[i + 1] = row_at[i] + piece.rows.row_begin.size();
    field_at[i + 1] = field_at[i] + piece.rows.field_begin.size();
  }
  rows.row_begin.resize(row_at.back());
  rows.row_line.resize(row_at.back());
  rows.field_begin.resize(field_at.back());
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (Index i = 0; i < count; ++i) {
    Piece& piece = pieces[std::size_t(i)];
    place_in(rows.row_begin, row_at[std::size_t(i)], piece.rows.row_begin);
    place_in(rows.row_line, row_at[std::size_t(i)], piece.rows.row_line);
    place_in(rows.field_begin, field_at[std::size_t(i)], piece.rows.field_begin);
    piece = {};
  }
  return lines;
}

}  // namespace bondstatic
