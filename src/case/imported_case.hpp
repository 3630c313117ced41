// The case file of an imported packing, for people to read and to go on from.
#pragma once

#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/foreign_setup.hpp"

namespace bondstatic {

/// What the case file tells besides the packing, whose tables lie beside it.
struct ImportedCase {
  std::string origin;           ///< "packing.data, in.lammps"
  bool parallel_bonds = false;  ///< some pairs are bonded twice
};

/// Of kn, ks, kt, kb those that some bonds lack.
std::vector<std::string> missing_stiffness(const ForeignModel& model);

/// What the user has to write into the case before it can be solved: "the stiffness of the bonds (kn, ks)".
std::vector<std::string> to_be_filled_in(const ForeignModel& model, const ForeignSetup& setup);

/// TOML that reads the tables particles.csv and bonds.csv (formats/write/packing.hpp). What no file gives is
/// asked for in comments marked FILL IN; where the case cannot be solved without it, reading the case ends
/// with a fault at that block.
std::string imported_case(const ForeignModel& model, const ForeignSetup& setup, const ImportedCase& about);

}  // namespace bondstatic
