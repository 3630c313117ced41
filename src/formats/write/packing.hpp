// A packing as this project's own tables, which a case reads again to the last digit:
//
//     particles  id, x, y, z, radius, density, group
//     bonds      id, a, b, what the file gives of kn, ks, kt, kb, contact_point, radius, ..., then the
//                numbers that a static solve does not use (strengths, damping)
//
// Columns of which no row has a value are not written.
#pragma once

#include "formats/foreign_model.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

void write_particle_table(OutputFile& file, const ForeignModel& model);
void write_bond_table(OutputFile& file, const ForeignModel& model);

}  // namespace bondstatic
