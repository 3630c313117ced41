// The tables that commands write (io/csv_writer.hpp), by column. Their last columns are called as the user's
// outputs, whatever these are: "time", "force #2", "12".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/table.hpp"

namespace bondstatic {

class CsvColumns {
 public:
  /// Nothing where the file is not there. Throws InputError where it cannot be read or is no table.
  static std::optional<CsvColumns> read(const std::string& file);

  const std::vector<std::string>& names() const { return names_; }
  Index rows() const { return table_ ? table_->rows() : 0; }
  /// Of the first column with this name, or -1.
  int find(const std::string& name) const;

  /// Empty fields are NaN. Throws InputError where others are no numbers.
  std::vector<double> numbers(int column) const;
  std::vector<Index> whole_numbers(int column) const;
  std::vector<std::string> texts(int column) const;
  /// Throws InputError where there is no such column.
  std::vector<double> numbers(const std::string& name) const;
  std::vector<Index> whole_numbers(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;

 private:
  int required(const std::string& name) const;

  std::string file_;
  std::vector<std::string> names_;
  std::optional<Table> table_;  ///< absent where there are no rows
};

}  // namespace bondstatic
