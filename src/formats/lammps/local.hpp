// Dumps of LAMMPS and LIGGGHTS in style local: bonds, a line each (documentation page "dump").
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// One step's bonds as a model without particles.
std::optional<ForeignModel> read_lammps_local(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults);

std::optional<BondState> read_lammps_local_state(const std::string& path, const ReadOptions& options,
                                                 const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
