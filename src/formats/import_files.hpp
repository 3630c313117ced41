// Files of one model, of whatever code, read and joined.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "formats/foreign_setup.hpp"
#include "formats/join_models.hpp"
#include "formats/readers.hpp"

namespace bondstatic {

struct ImportOptions {
  ReadOptions read;  ///< its progress is not used
  /// Hears which part of which file is read; may throw to give up. May be null.
  std::function<void(const std::string& file, double part)> progress;
};

struct Imported {
  std::vector<std::string> files;  ///< that were read
  ForeignModel model;              ///< sound in the sense of join_models()
  Index parallel_bonds = 0;
  ForeignSetup setup;  ///< of an input script; else empty
};

/// A LAMMPS input script among the files (is_lammps_script_name()) is joined to the packing by
/// apply_script(); where it is the only file, the one that its read_data names is read, too. Throws
/// InputError.
Imported import_files(const std::vector<std::string>& paths, const ImportOptions& options);

}  // namespace bondstatic
