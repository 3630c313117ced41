// model.vtu: points are particles, lines are bonds.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/state.hpp"
#include "io/column.hpp"
#include "io/output_file.hpp"
#include "model/piece.hpp"

namespace bondstatic {

/// `more`: further columns, of particles and of bonds.
void write_grid(OutputFile& file, const Model& model, const State& state,
                const std::vector<Column>& more_of_particles = {},
                const std::vector<Column>& more_of_bonds = {});

/// A rank's own particles, the bonds that it owns, and copies of the particles at their far ends.
void write_grid_piece(OutputFile& file, const Piece& piece, const State& state);

/// model.pvtu, which makes one grid of the pieces.
void write_grid_of_pieces(OutputFile& file, const std::vector<std::string>& pieces);

}  // namespace bondstatic
