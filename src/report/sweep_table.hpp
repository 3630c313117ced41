// sweep.csv: what was varied, and what came out.
#pragma once

#include <string>
#include <vector>

#include "report/csv_columns.hpp"

namespace bondstatic {

struct SweepKey {
  std::string name;                ///< "bonds.0.law"
  std::string short_name;          ///< "law", where no other key is called so
  std::vector<std::string> texts;  ///< row by row, without the quotes of the case file
  std::vector<double> numbers;     ///< empty where not all are numbers with the same unit or none
  std::string unit;
  std::size_t distinct = 0;

  bool is_number() const { return !numbers.empty(); }
};

struct SweepColumn {
  std::string name;
  std::vector<double> values;  ///< NaN where the point failed
};

struct SweepTable {
  std::vector<SweepKey> keys;
  std::vector<SweepColumn> counts;  ///< of particles and of bonds
  std::vector<SweepColumn> outputs;
  std::vector<std::string> status;   ///< "done", or why not
  std::vector<std::string> columns;  ///< as in the file

  std::size_t rows() const { return status.size(); }
  bool done(std::size_t row) const { return status[row] == "done"; }
};

/// Throws InputError where it is no such table.
SweepTable read_sweep(const std::string& file, const CsvColumns& csv);

/// Whether each value of `of` is that of one value of `on`: what changes together with another key, or not at
/// all.
bool depends_on(const SweepKey& of, const SweepKey& on);

/// Words that tell values of a key apart: of inline tables only the entries that are not in all of them.
std::vector<std::string> value_names(const SweepKey& key);

}  // namespace bondstatic
