// Steps of a dump of LAMMPS or LIGGGHTS, whatever its rows are: where they lie in the file, and one of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formats/lammps/dump_header.hpp"
#include "formats/readers.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

/// A step as it lies in the file.
struct DumpStep {
  Index step = 0;
  std::uint64_t offset = 0;  ///< of its first line
  int line = 0;              ///< number of that
  Index rows = 0;            ///< announced
  Index rows_there = 0;
  bool complete = false;
};

/// All steps; what is wrong with the frame is a fault, steps cut short are not. `progress` may be null.
std::optional<std::vector<DumpStep>> find_dump_steps(LineReader& reader,
                                                     const std::function<void(double part)>& progress,
                                                     std::vector<Fault>& faults);

/// A step chosen, and what was read of it.
struct DumpRows {
  DumpHeader header;
  std::vector<std::vector<double>> values;  ///< of each column that was asked for, by row
  std::vector<int> line;                    ///< of each row
  Index steps = 0;                          ///< in the file
  bool repeated = false;                    ///< the file has this step several times; this is the last
};

/// "Step 1000 was read, of 2 in the file", without a full stop.
std::string about_step(const DumpRows& rows);

struct WantedColumn {
  int column = 0;                     ///< in the header's columns
  std::optional<Index> whole_from{};  ///< a whole number, at least this; else any finite one
};
/// What is wanted of a step; appends what is wrong with its header.
using ChooseColumns = std::function<std::vector<WantedColumn>(const DumpHeader&, std::vector<Fault>&)>;

/// Reads the step that the options ask for. A step cut short, and one that is not there, are faults that say
/// which there are.
std::optional<DumpRows> read_dump_rows(const std::string& path, const ReadOptions& options,
                                       const ChooseColumns& choose, const Place& named_at,
                                       std::vector<Fault>& faults);

}  // namespace bondstatic
