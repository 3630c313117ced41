// What a file of another DEM code says of a model, in this project's words: particles, bonds and their
// numbers, before any law. Readers fill it; `import` writes it as a case, and [[particles]] and [[bonds]]
// take from it what their `file` names.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic {

/// A bond as files list it: by the ids of its particles. -1 where the file has no id or type.
struct ForeignBond {
  Index id = -1;
  Index a = 0;
  Index b = 0;
  Index type = -1;
};

/// What a user must know of a reading, each a full sentence: an importer's worth is what it says here.
struct ImportNotes {
  std::vector<std::string> taken;
  std::vector<std::string> assumed;
  std::vector<std::string> left_out;
};

struct ForeignModel {
  std::string format;  ///< "LAMMPS data file (bpm/sphere)"
  std::string title;   ///< what the file calls itself, often empty

  std::vector<Particle> particles;       ///< radius, density NaN and id -1 where the file has none
  std::vector<int> particle_line;        ///< of each, for messages; empty where they come without lines
  std::vector<std::string> group_names;  ///< "type 1", "type 2", ...
  std::vector<int> group;                ///< of each particle, in group_names; empty where there are none

  std::vector<ForeignBond> bonds;
  std::vector<int> bond_line;
  /// Numbers of single bonds under the names of this project's bond tables (kn, ks, kt, kb, radius,
  /// contact_point as a fraction of the branch from a, ...); NaN where a bond has none. In units of the file.
  std::map<std::string, std::vector<double>> bond_columns;
  /// Likewise, what a static solve does not use: strengths, damping. Kept in the bond table of an import.
  std::map<std::string, std::vector<double>> kept_columns;

  std::optional<Cell> cell;  ///< only where some direction is periodic
  /// Where a file has a box but does not say along which edges it repeats (LAMMPS data): none of them, here.
  std::optional<Cell> box;
  bool si = false;  ///< the file says that its numbers are SI
  ImportNotes notes;
};

}  // namespace bondstatic
