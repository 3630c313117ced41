// LAMMPS data files (read_data, write_data; documentation page "read_data").
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// A data file does not say which directions are periodic. They are taken as such where image flags or bonds
/// longer than their particles reach prove it, or where the first line says so as this project's export does
/// ("boundary = p p f").
std::optional<ForeignModel> read_lammps_data(const std::string& path, const ReadOptions& options,
                                             const Place& named_at, std::vector<Fault>& faults);

/// The particles of a data file as the state at the step that its first line names. Positions are unwrapped.
std::optional<ParticleState> read_lammps_data_state(const std::string& path, const ReadOptions& options,
                                                    const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
