// The rows of a table: where they and their fields begin, found in pieces of the text at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/types.hpp"

namespace bondstatic {

inline constexpr int most_table_faults = 20;

/// Adds a fault unless twenty are there already; false then, after saying that there is more.
class LimitedFaults {
 public:
  explicit LimitedFaults(std::vector<Fault>& faults) : faults_(faults) {}
  bool add(const Place& place, const std::string& message, const std::string& cure);

 private:
  std::vector<Fault>& faults_;
  int count_ = 0;
};

struct TableRows {
  std::vector<std::size_t> row_begin;    ///< in the text
  std::vector<int> row_line;             ///< counted from 1
  std::vector<std::size_t> field_begin;  ///< in the text, row by row
};

struct TableShape {
  std::string file;
  char separator = ',';
  std::size_t columns = 0;
};

/// The rows of text[begin, ...), whose first line is number first_line + 1. The faults of each piece are told
/// in the order of the text, so that neither they nor the rows depend on `threads`. Returns how many lines
/// there are; what is found after the twentieth fault is of no use.
int find_rows(std::string_view text, std::size_t begin, int first_line, const TableShape& shape,
              LimitedFaults& faults, TableRows& rows, int threads);

/// The fault of an open quote, see FieldStarts.
bool add_open_quote(LimitedFaults& faults, const Place& place);

}  // namespace bondstatic
