// Dumps of LAMMPS and LIGGGHTS in style atom or custom (documentation page "dump").
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// One step's particles as a model.
std::optional<ForeignModel> read_lammps_dump(const std::string& path, const ReadOptions& options,
                                             const Place& named_at, std::vector<Fault>& faults);

std::optional<ParticleState> read_lammps_dump_state(const std::string& path, const ReadOptions& options,
                                                    const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
