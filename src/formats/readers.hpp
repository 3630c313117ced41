// Readers of other codes' files. Each appends what is wrong to `faults`, with file, line, column and cure,
// and returns nothing then; none throws for what a file contains. Files are streamed: memory is that of what
// is read, not of the text.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/run_state.hpp"

namespace bondstatic {

enum class FileFormat {
  table,         ///< columns with a header line: CSV and the like, of this project, EDEM, PFC, YADE scripts
  lammps_data,   ///< read_data / write_data
  lammps_dump,   ///< LAMMPS and LIGGGHTS "ITEM: ATOMS"
  lammps_local,  ///< "ITEM: ENTRIES"
  yade_text,     ///< yade.export.text, textExt: numbers under a line #format
  musen_text,
};

/// From the first lines of the file; a fault where it cannot be read. What nothing speaks for is a table.
std::optional<FileFormat> detect_format(const std::string& path, const Place& named_at,
                                        std::vector<Fault>& faults);
std::string format_name(FileFormat format);

struct ReadOptions {
  std::string atom_style;  ///< of a LAMMPS data file: "bpm/sphere", "sphere", "hybrid sphere bond", ...
                           ///< "": as the file says in its Atoms section
  std::vector<std::string>
      bond_columns;           ///< of a local dump: which columns are a, b (and type): "c_bl[1]", ...
  std::optional<Index> step;  ///< of a series; absent: the last
  bool particles = true, bonds = true;  ///< what is wanted of a file that has both
  /// Called now and then with the part of the file that is read; may throw to give up. May be null.
  std::function<void(double part)> progress;
};

std::optional<ForeignModel> read_foreign_model(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults);

/// A step of a dump, or a table with the columns id, x, y, z (and orientations qw, qx, qy, qz or rotation
/// vectors rx, ry, rz).
std::optional<ParticleState> read_particle_state(const std::string& path, const ReadOptions& options,
                                                 const Place& named_at, std::vector<Fault>& faults);
std::optional<BondState> read_bond_state(const std::string& path, const ReadOptions& options,
                                         const Place& named_at, std::vector<Fault>& faults);

/// Steps that a dump holds, in its order.
std::optional<std::vector<Index>> dump_steps(const std::string& path, const Place& named_at,
                                             std::vector<Fault>& faults);

}  // namespace bondstatic
