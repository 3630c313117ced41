// yade.export.text and textExt: spheres in rows under a line "#format x_y_z_r" that names the columns
// (YADE, py/export.py). Six digits, no bonds, mostly no ids.
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// The formats x_y_z_r, x_y_z_r_matId, id_x_y_z_r_matId, x_y_z_r_attrs (whose columns the last comment names)
/// and x_y_z_r_clumpId, and any other whose words are among x, y, z, r, id, matId and unknown ones of one
/// number. Spheres are in groups by matId.
std::optional<ForeignModel> read_yade_text(const std::string& path, const ReadOptions& options,
                                           const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
