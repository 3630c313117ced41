// Tables as comma-separated values: a header line, then a line a row. Numbers are the shortest decimals that
// read back to the same double (at most 17 digits); NaN is an empty field.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/column.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

/// Columns of one component and of equal length.
void write_csv(OutputFile& file, std::span<const Column> columns);

/// Without the header line.
void write_csv_rows(OutputFile& file, std::span<const Column> columns);

/// The number as it stands in a table; "" for NaN.
std::string csv_number(double value);

/// Quoted where it holds a separator, a quote or a line end (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace bondstatic
