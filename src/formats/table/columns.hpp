// Columns of a table with a header line, or of an EDEM export, read as a stream: only what is wanted of them
// stays in memory.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/units.hpp"
#include "formats/readers.hpp"
#include "formats/table/column_names.hpp"
#include "io/line_reader.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {

/// How the fields of a column are read.
enum class Wanted {
  no,
  number,           ///< finite; an empty field is a fault
  positive,         ///< likewise
  number_or_empty,  ///< NaN where empty
  whole,            ///< not negative, below 9e15
  number_if_any,    ///< NaN where the field is no finite number
  word,             ///< numbers[row] is a position in `words`
};
enum class TableKind { particles, bonds, unknown };
/// Asked of each heading; of an EDEM export before all headings are known, hence of unknown kind.
using WantColumn = std::function<Wanted(const ColumnName&, TableKind)>;

struct TableColumn {
  ColumnName heading;
  Place place;  ///< of the heading
  Wanted wanted = Wanted::no;
  std::vector<double> numbers;
  std::vector<std::string> words;  ///< distinct, in the order in which they come first
  std::map<std::string, int, std::less<>> position_of_word;
};

struct TableColumns {
  std::string file;
  Place header;
  std::vector<TableColumn> columns;
  std::vector<int> line;                ///< of each row
  bool edem = false;                    ///< EDEM's results export: blocks of queries under a time
  double time = not_given;              ///< of the EDEM block
  std::vector<std::string> left_lines;  ///< above the header, neither empty nor comments

  std::size_t rows() const { return line.size(); }

  /// A column that is wanted, null where there is none. Two of one meaning are a fault, appended.
  TableColumn* find(const Aliases& aliases, std::vector<Fault>& faults);
  bool has(const Aliases& aliases) const;
};

/// The header is the first line that names columns x, y, z or the two ends of bonds, or a comment that does
/// so above a row of numbers; up to 200 lines before it are skipped. ReadOptions::step counts the times of an
/// EDEM export from 1. Faults end after twenty of a kind.
std::optional<TableColumns> read_table_columns(const std::string& path, const ReadOptions& options,
                                               const WantColumn& want, const Place& named_at,
                                               std::vector<Fault>& faults);

/// Reads rows into the columns; `line` is the first of them where it has been read already. A row that ends
/// with a separator has no field behind it.
void read_table_rows(LineReader& reader, std::optional<std::string_view> line, char separator,
                     const ReadOptions& options, TableColumns& table, std::vector<Fault>& faults);

/// Takes one field into a column that is wanted. `place` is asked for where the field is at fault.
void append_field(TableColumn& column, std::string_view field, const std::function<Place()>& place,
                  LimitedFaults& faults);

/// Bonds where two columns name the particles of each, particles where x, y, z are there.
TableKind kind_of(const TableColumns& table);

/// Says what a table lacks whose kind is unknown.
void fault_unknown_kind(const TableColumns& table, std::vector<Fault>& faults);

}  // namespace bondstatic
