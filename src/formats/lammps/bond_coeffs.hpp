// Section "Bond Coeffs" of a LAMMPS data file (documentation pages "read_data", "bond_bpm_rotational").
#pragma once

#include <array>
#include <map>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/lammps/bpm_rotational.hpp"
#include "formats/lammps/types.hpp"

namespace bondstatic {

/// Of each bond type, the numbers of bpm/rotational in its order.
using BondCoefficients = std::map<Index, std::array<double, bpm_rotational_columns.size()>>;

/// Reads the section's rows; those of other bond styles are left out, and told.
BondCoefficients read_bond_coefficients(DataSections& sections, RowFields& fields, const TypeNumbers& types,
                                        ImportNotes& notes);

/// The model's columns of the twelve, each as long as its bonds: made, of NaN, where there are none.
std::array<std::vector<double>*, bpm_rotational_columns.size()> bpm_rotational_values(ForeignModel& model);

/// As columns of the model's bonds; types without coefficients are a fault.
void spread_bond_coefficients(const BondCoefficients& coefficients, const Place& section, ForeignModel& model,
                              std::vector<Fault>& faults);

}  // namespace bondstatic
