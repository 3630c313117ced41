// Bonds as bond_style bpm/rotational takes them: a type for each distinct stiffness, contact point at
// mid-length (LAMMPS, src/BPM/bond_bpm_rotational.cpp: half of the shear force's moment at either end).
#pragma once

#include <vector>

#include "formats/write/export_formats.hpp"

namespace bondstatic {

struct LammpsBonds {
  std::vector<SectionStiffness> types;  ///< type t + 1; no coupling
  std::vector<Index> type;              ///< of each bond, from 1
  double shortest = 0, longest = 0;
};

/// Appends to `notes` what LAMMPS cannot carry.
LammpsBonds lammps_bonds(const ExportInput& input, ExportNotes& notes);

}  // namespace bondstatic
