// A LAMMPS input script joined to the packing that it runs.
#pragma once

#include <optional>

#include "formats/foreign_model.hpp"
#include "formats/foreign_setup.hpp"
#include "formats/lammps/script.hpp"

namespace bondstatic {

/// Gives the bonds the stiffness of bond_coeff by their types (kr ks kt kb are kn ks kt kb at mid-length;
/// with `normalize yes`, kn and ks are kr and ks over the bond's length) and the model the cell of
/// `boundary`, and says what the fixes hold and load:
///
///     fix freeze               holds all six degrees of freedom
///     fix setforce 0 NULL 0    holds the directions with 0: nothing accelerates them
///     no fix nve... of them    holds, where others have one: LAMMPS moves what is integrated
///     fix addforce fx fy fz    a force on each particle
///     fix gravity g vector     an acceleration
///
/// The script's notes join the model's. Nothing, and faults, where the two do not fit.
std::optional<ForeignSetup> apply_script(const LammpsScript& script, ForeignModel& model,
                                         std::vector<Fault>& faults);

}  // namespace bondstatic
