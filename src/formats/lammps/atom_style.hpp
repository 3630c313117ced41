// Columns of the Atoms section of a LAMMPS data file (documentation page "read_data").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// Three image flags may follow the columns.
struct AtomStyle {
  std::string name;  ///< "bpm/sphere", "hybrid sphere bond"
  std::vector<std::string> columns;

  int find(const std::string& column) const;  ///< -1 where the style has none
};

/// `text` is a style's name or "hybrid" and several. Nothing where it is unknown or says too little; `wrong`
/// then is a fault without a place.
std::optional<AtomStyle> find_atom_style(const std::string& text, Fault& wrong);

/// Names of styles with so many fields in a line, with or without image flags: "bpm/sphere, dipole".
std::string atom_styles_of_width(std::size_t fields);

}  // namespace bondstatic
