// A table of named columns in a text file. Separators are commas, semicolons, tabs or blanks, as the header
// line has them; # starts a comment; fields may stand in double quotes; line ends may be CRLF.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/types.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {

class Table {
 public:
  /// The first line that is neither empty nor a comment names the columns. No names, a name twice and rows of
  /// another length are faults, appended; the table is then absent.
  /// Neither the table nor the faults depend on `threads`, which holds for the columns as well.
  static std::optional<Table> parse(std::string text, const std::string& file, std::vector<Fault>& faults,
                                    int threads = 1);

  Index rows() const { return Index(rows_.row_begin.size()); }
  const std::vector<std::string>& names() const { return names_; }

  /// The column that has one of these names, letter case free, or -1; two of them are a fault, appended.
  int find(std::span<const std::string> aliases, std::vector<Fault>& faults) const;

  /// A column as finite numbers. Empty fields are faults, or NaN where `may_be_empty`. Faults name the column
  /// and end after twenty of a column.
  std::vector<double> numbers(int column, bool may_be_empty, std::vector<Fault>& faults) const;

  /// A column as whole numbers, not negative ("12" or "12.0").
  std::vector<Index> whole_numbers(int column, std::vector<Fault>& faults) const;

  std::vector<std::string> texts(int column) const;

  /// Of a field; column -1 means the row's first, row -1 the header.
  Place place(Index row, int column) const;
  /// The same without the file; of a row only.
  std::pair<int, int> line_and_column(Index row, int column) const;

 private:
  void name_columns(std::string_view line, int line_number, const std::vector<std::size_t>& starts,
                    std::vector<Fault>& faults);
  std::string_view field(Index row, int column) const;
  std::string number_fault(std::string_view text, double value, int column) const;

  std::string text_;
  std::string file_;
  std::vector<std::string> names_;
  std::vector<int> name_columns_;
  int header_line_ = 0;
  TableRows rows_;
  char separator_ = ',';
  int threads_ = 1;
};

/// Reads the file and parses it; see read_text_file for what else may be at fault.
std::optional<Table> read_table(const std::string& path, const Place& named_at, std::vector<Fault>& faults,
                                int threads = 1);

}  // namespace bondstatic
