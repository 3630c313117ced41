// Tables with a header line: of this project, EDEM's results exports, listings of PFC, and what the exporter
// scripts write. Columns are found by name (formats/table/column_names.hpp); units in brackets behind a name
// are honoured, and numbers are then SI.
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// Particles (x, y, z and what there is of id, radius or diameter, density or mass, group) or bonds (two ids
/// and what there is of stiffness, radius, contact point, law parameters, strengths), by the header.
std::optional<ForeignModel> read_foreign_table(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults);

/// Needs id, x, y, z. Positions are x + ux where displacements stand under this project's names ux, uy, uz,
/// as in particles.csv of a solve, and x as it is beside other displacements (disp_x: codes accumulate them
/// and move x along). Orientations come from a quaternion, or a rotation vector rx, ry, rz.
std::optional<ParticleState> read_state_table(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults);

/// Needs two columns of particle ids; the others that hold numbers are kept under their names.
std::optional<BondState> read_bond_state_table(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
