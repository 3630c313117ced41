// Which particle and bond of a run is which of the case, and how far they have moved.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/compare.hpp"
#include "bondstatic/error.hpp"
#include "formats/run_state.hpp"

namespace bondstatic {

/// Particles by their ids; displacements from the case's positions, in a periodic cell to the nearest image.
/// Where one particle alone holds a cell, the run is first shifted to where that one has its static place.
/// Rotations are those of the orientations, which a run starts without any. Appends to `faults`, and returns
/// nothing, where an id comes twice, and where the state can be none of this case: other units, another
/// origin, another packing. `file`: in messages. `statics`: of the load case.
std::optional<RunState> match_particles(const Model& model, const State& statics, const ParticleState& state,
                                        const std::string& file, std::vector<Fault>& faults);

/// Names of the columns with forces, and with moments where there are any.
struct BondForceColumns {
  std::array<std::string, 3> force{"fx", "fy", "fz"};
  std::array<std::string, 3> moment{"mx", "my", "mz"};
};

/// Forces of bonds into a state that match_particles made. Files mean one of two: the force on the second
/// particle of a row (bonds.csv of this program) or that on the first (LAMMPS, compute bond/local). The one
/// that fits the static answer is taken, and noted. Forces along the bond alone are the normal force; LAMMPS'
/// bond styles bpm give them times the distance, as compute_bond_local.cpp multiplies the force of
/// bond_bpm_rotational.cpp's single() by the whole distance vector: where that fits better the distance is
/// divided out, and noted. Faults where columns are missing and where hardly any bond is one of the case's.
void match_bonds(const Model& model, const State& statics, const BondState& bonds,
                 const BondForceColumns& columns, const std::string& file, RunState& run,
                 std::vector<Fault>& faults);

}  // namespace bondstatic
