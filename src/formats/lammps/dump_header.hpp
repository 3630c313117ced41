// What stands above the rows of a step in a dump of LAMMPS or LIGGGHTS (documentation pages "dump" and
// "dump_modify"; dump_custom.cpp, dump_local.cpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bondstatic/model.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

struct DumpHeader {
  Index step = 0;
  double time = not_given;
  std::string units;            ///< above the first step only, and where dump_modify asked for it
  Index rows = 0;               ///< announced
  std::string label;            ///< "ATOMS", "ENTRIES", or what dump_modify label says
  std::optional<Cell> box;      ///< periodic as its letters say; nothing where the dump has no box
  bool boundary_known = false;  ///< it has the letters
  std::vector<std::string> columns;
  std::vector<int> column_at;  ///< of each name, in that line; counted from 1
  int columns_line = 0;
};

enum class HeaderEnd {
  rows,      ///< the rows are next
  cut,       ///< the file ends within the header
  at_fault,  ///< and the fault has been appended
};

/// Reads on from `line`, the first of the header, which the reader has just given. `header.step` is -1 until
/// it has been read.
HeaderEnd read_dump_header(LineReader& reader, std::string_view line, DumpHeader& header,
                           std::vector<Fault>& faults);

}  // namespace bondstatic
