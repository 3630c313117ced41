// Along which directions a LAMMPS data file must be periodic, which it does not say.
#pragma once

#include <array>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/lammps/data_header.hpp"

namespace bondstatic {

/// Of each particle, how many boxes it has wandered; empty where the file has no flags.
using ImageFlags = std::vector<std::array<std::int32_t, 3>>;

/// Sets model.cell where the title, image flags that are not zero or bonds through a face prove that the box
/// repeats, model.box where nothing does, and says why. Ids of bonds must be known.
void find_periodic_directions(const DataHeader& header, const ImageFlags& images, ForeignModel& model);

}  // namespace bondstatic
