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

/// id, radius; displacement, rotation, reaction_force, reaction_moment as vectors.
std::vector<Column> point_data(const Model& model, const State& result);

}  // namespace bondstatic
