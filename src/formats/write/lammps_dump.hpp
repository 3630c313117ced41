// A step of a run as LAMMPS' dump custom writes it (dump.rst), for OVITO, ParaView and other readers of
// dumps.
#pragma once

#include "formats/run_state.hpp"
#include "formats/write/lammps_box.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

/// Columns id, type, x, y, z (xu, yu, zu where positions are unwrapped), and those of orientation (quatw
/// quati quatj quatk), velocity (vx ...), angular_velocity (omegax ...), force (fx ...), torque (tqx ...) and
/// radius that are there; numbers round-trip.
void write_lammps_dump(OutputFile& file, const ParticleState& state, const LammpsBox& box);

}  // namespace bondstatic
