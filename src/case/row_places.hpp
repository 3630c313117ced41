// Where the rows of a file stand, without a copy of its name for each.
#pragma once

#include <string>
#include <vector>

#include "io/table.hpp"

namespace bondstatic {

class RowPlaces {
 public:
  RowPlaces() = default;
  /// Of the fields of one column.
  RowPlaces(const Table& table, int column) : file_(table.place(-1, -1).file) {
    at_.reserve(std::size_t(table.rows()));
    for (Index row = 0; row < table.rows(); ++row) at_.push_back(table.line_and_column(row, column));
  }

  /// Of lines that are told one by one; all of the file's name only where there are none.
  RowPlaces(std::string file, const std::vector<int>& lines, std::size_t rows) : file_(std::move(file)) {
    at_.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row)
      at_.emplace_back(row < lines.size() ? lines[row] : 0, row < lines.size() ? 1 : 0);
  }

  bool empty() const { return at_.empty(); }
  Place operator[](std::size_t row) const { return {file_, at_[row].first, at_[row].second}; }

  /// Only these rows, in this order.
  void keep(const std::vector<Index>& rows) {
    std::vector<std::pair<int, int>> kept;
    for (const Index row : rows) kept.push_back(at_[std::size_t(row)]);
    at_ = std::move(kept);
  }

 private:
  std::string file_;
  std::vector<std::pair<int, int>> at_;  ///< line, column
};

}  // namespace bondstatic
