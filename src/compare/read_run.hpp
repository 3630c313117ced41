// The end state of a run from its files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/compare.hpp"
#include "compare/match.hpp"

namespace bondstatic {

/// A step of a dump, the last unless said, or a table. Throws InputError with what is wrong with the file,
/// and where it can be no state of this case. `statics`: of the load case.
RunState read_run(const Model& model, const State& statics, const std::string& file,
                  std::optional<Index> step);

/// Where the forces of a run's bonds are.
struct BondForceFile {
  std::string file;              ///< local dump or table
  std::vector<std::string> ids;  ///< columns of a bond's particles; none: as the file itself names them
  BondForceColumns force;
};

/// Of three names, or six; of none fx ... mz. Throws InputError where they are another number.
BondForceColumns bond_force_columns(const std::vector<std::string>& names);

/// Adds them to the state. Of the step that the particles are of; a file of one step is taken as it is.
/// Throws InputError.
void read_bond_forces(const Model& model, const State& statics, const BondForceFile& bonds,
                      std::optional<Index> step, RunState& run);

}  // namespace bondstatic
