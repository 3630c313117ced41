// What a LAMMPS input script says of the model that it runs, as far as a data file does not: units, periodic
// directions, bond stiffness, groups and fixes. The script is read from top to bottom, once; nothing of it is
// executed. What it does not take is told in its notes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/lammps/commands.hpp"
#include "formats/lammps/groups.hpp"

namespace bondstatic {

/// A `bond_coeff` command: numbers for bond types first ... last.
struct ScriptBondCoefficients {
  WholeRange types;
  std::vector<double> numbers;  ///< the twelve of bpm/rotational
  Place place;
};

/// A `fix` command: ID group style arguments.
struct ScriptFix {
  ScriptCommand command;
  const std::string& id() const { return command.word(1); }
  const std::string& group() const { return command.word(2); }
  const std::string& style() const { return command.word(3); }
};

struct LammpsScript {
  std::string file;
  std::string units = "lj";
  std::string atom_style;  ///< "bpm/sphere", "hybrid sphere bond"; empty: not said
  std::string data_file;   ///< of read_data, beside the script where it is relative; empty: none
  Place data_place;
  std::array<bool, 3> periodic{true, true, true};
  std::string bond_style;
  bool normalize = false;  ///< bpm/rotational: kr and ks are forces, divided by the bond's length
  std::vector<ScriptBondCoefficients> bond_coefficients;
  std::vector<ScriptGroup> groups;
  std::vector<ScriptFix> fixes;  ///< in force at the last run or minimize, or at the end where there is none
  ScriptVariables variables;     ///< where the fixes are in force
  ImportNotes notes;
};

/// Whether a file's name says that it is an input script: in.NAME, NAME.in, NAME.lammps, NAME.lmp.
bool is_lammps_script_name(const std::string& path);

std::optional<LammpsScript> read_lammps_script(const std::string& path, const Place& named_at,
                                               std::vector<Fault>& faults);

/// A constant of a script: a number, v_NAME of a constant variable. Nothing, and a fault, where it is none.
std::optional<double> script_number(const ScriptCommand& command, std::size_t word,
                                    const ScriptVariables& variables, std::vector<Fault>& faults);

}  // namespace bondstatic
