// The header of a LAMMPS data file (documentation page "read_data").
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "formats/foreign_model.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

struct DataCount {
  Index value = 0;
  int line = 0;
};

struct DataHeader {
  std::string title;                            ///< the first line
  std::map<std::string, DataCount> counts;      ///< "atoms", "bond types", ...; what is not there is 0
  Cell box;                                     ///< periodic along nothing
  std::string units;                            ///< as the title says: "units = si"; often empty
  std::optional<Index> step;                    ///< likewise: "timestep = 1000"
  std::optional<std::array<bool, 3>> periodic;  ///< likewise: "boundary = p p f"

  Index count(const std::string& of) const;
};

/// What ends the header: the line of the first section, empty where the file ends.
struct DataHeaderEnd {
  DataHeader header;
  std::string section;
};
std::optional<DataHeaderEnd> read_data_header(LineReader& reader, ImportNotes& notes,
                                              std::vector<Fault>& faults);

}  // namespace bondstatic
