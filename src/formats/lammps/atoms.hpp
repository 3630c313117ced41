// Section "Atoms" of a LAMMPS data file (documentation page "read_data").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/lammps/data_periodic.hpp"
#include "formats/lammps/sections.hpp"
#include "formats/lammps/types.hpp"

namespace bondstatic {

/// Of each particle, what a model does not hold.
struct LammpsAtoms {
  std::vector<Index> types;
  ImageFlags images;
};

/// Fills the particles of the model, of which about `announced` are expected. Returns the number of rows, or
/// nothing where the section is no use.
std::optional<Index> read_lammps_atoms(DataSections& sections, const LineReader& reader, Index announced,
                                       const ReadOptions& options, const TypeNumbers& type_numbers,
                                       ForeignModel& model, LammpsAtoms& atoms, std::vector<Fault>& faults);

}  // namespace bondstatic
