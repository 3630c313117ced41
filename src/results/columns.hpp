// The answer of one load case as named columns, for the tables and for model.vtu. The columns look into the
// model and the state, which must outlive them.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "io/column.hpp"

namespace bondstatic {

std::vector<Column> particle_columns(const Model& model, const State& result);
/// id, a, b.
std::vector<Column> bond_ends(const Model& model);
std::vector<Column> bond_columns(const Model& model, const State& result);

/// id, radius; displacement, rotation, reaction_force, reaction_moment as vectors; of the state's load case,
/// fixed (1 x, 2 y, 4 z, 8 rx, 16 ry, 32 rz, summed), and the sums of the loads, applied_force and
/// applied_moment. Where the state names no load case of the model, what all of them share.
std::vector<Column> point_data(const Model& model, const State& result);
/// bond_columns(), and radius: of the bond's section, NaN where its law has none.
std::vector<Column> line_data(const Model& model, const State& result, int threads);

}  // namespace bondstatic
