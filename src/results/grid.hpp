// model.vtu: points are particles, lines are bonds.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/state.hpp"
#include "io/output_file.hpp"
#include "model/piece.hpp"

namespace bondstatic {

void write_grid(OutputFile& file, const Model& model, const State& state);

/// A rank's own particles, the bonds that it owns, and copies of the particles at their far ends.
void write_grid_piece(OutputFile& file, const Piece& piece, const State& state);

/// model.pvtu, which makes one grid of the pieces.
void write_grid_of_pieces(OutputFile& file, const std::vector<std::string>& pieces);

}  // namespace bondstatic
