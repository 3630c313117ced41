// The files of a LAMMPS model, one function each.
#pragma once

#include <string>
#include <vector>

#include "formats/write/export_formats.hpp"
#include "formats/write/lammps_bonds.hpp"
#include "formats/write/lammps_box.hpp"
#include "formats/write/lammps_roles.hpp"

namespace bondstatic {

struct LammpsModel {
  const ExportInput& input;
  LammpsRoles roles;
  LammpsBonds bonds;
  LammpsBox box;
  Index id_shift = 0;  ///< LAMMPS' ids begin at 1

  Index id(std::size_t particle) const { return input.model.particles[particle].id + id_shift; }
};

inline constexpr const char* lammps_data_file = "model.data";
inline constexpr const char* lammps_deck_file = "in.lammps";
inline constexpr const char* lammps_coefficient_file = "bond_coeffs.lammps";
inline constexpr const char* lammps_static_dump = "dump.static";

/// With more bond types than this, their coefficients stand in a file of their own.
inline constexpr std::size_t lammps_types_in_deck = 100;

/// Strengths that no bond of a linear model reaches.
inline constexpr double lammps_strength = 1e30;

/// k_r k_s k_t k_b, then four strengths and four damping coefficients, as bond_coeff and the section Bond
/// Coeffs take them. Stiffness is against twisting, then bending; versions differ in what they say of the
/// order of the strengths, which are all alike here.
std::string lammps_coefficients(const SectionStiffness& type);

/// read_data file for atom_style bpm/sphere; Bond Coeffs, which the deck gives on its own, are there for
/// readers of the file.
void write_lammps_data(const LammpsModel& model, OutputFile& file);

/// Files of atomfile-style variables (LAMMPS, variable.rst): a count, then an id and a number a line.
struct LammpsVariable {
  std::string name;  ///< of the variable and, with ".txt" behind it, of the file
  std::vector<std::size_t> particles;
  std::vector<double> values;
};
void write_lammps_variable(const LammpsModel& model, const LammpsVariable& variable, OutputFile& file);

/// The deck; `variables` are those that it refers to, to be written beside it.
std::string lammps_deck(const LammpsModel& model, const ExportNotes& notes,
                        std::vector<LammpsVariable>& variables);

}  // namespace bondstatic
