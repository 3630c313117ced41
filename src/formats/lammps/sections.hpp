// The sections of a LAMMPS data file after its header: their names and their rows (documentation page
// "read_data").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "formats/readers.hpp"
#include "formats/row_fields.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

class DataSections {
 public:
  /// `first` is the line of the first section, which `reader` has just given; empty where there is none.
  DataSections(LineReader& reader, std::string first, const ReadOptions& options, std::vector<Fault>& faults);

  /// Begins the next section. False where there is none, or reading is at fault.
  bool next_section();

  const std::string& name() const { return name_; }    ///< "Bond Coeffs"
  const std::string& style() const { return style_; }  ///< of the comment behind the name, often empty
  int line() const { return name_line_; }

  /// The next line of the section that is neither empty nor a comment. Nothing at the section's end.
  std::optional<std::string_view> next_row();

  /// Reads over the rows that are left; how many they were.
  Index skip_rows();

 private:
  bool names_a_section(std::string_view line);

  LineReader& reader_;
  const ReadOptions& options_;
  std::vector<Fault>& faults_;
  LimitedFaults skipped_faults_;  // of lines that LAMMPS reads over
  std::string pending_;
  int pending_line_ = 0;
  std::string name_, style_;
  int name_line_ = 0;
  bool ended_ = true;
  std::vector<std::string_view> words_;
};

/// The section of LAMMPS that a misspelt name was meant to be; "" for a right name, and for one like none.
std::string nearest_lammps_section(const std::string& name);

}  // namespace bondstatic
