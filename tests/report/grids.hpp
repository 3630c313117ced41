// Grids of small models, written as the commands write them.
#pragma once

#include <random>
#include <string>

#include "io/file_set.hpp"
#include "io/scratch_folder.hpp"
#include "results/grid.hpp"
#include "results/pieces.hpp"

namespace bondstatic::test {

inline std::string write_grid_file(const ScratchFolder& scratch, const std::string& folder,
                                   const Model& model, const State& state,
                                   const std::vector<Column>& more_of_bonds = {}) {
  FileSet files(scratch / folder);
  files.supersede({"model.vtu"});
  write_grid(files.create("model.vtu"), model, state, {}, more_of_bonds);
  files.commit();
  return (scratch / folder / "model.vtu").string();
}

/// The pieces that so many ranks write of a load case.
inline std::vector<std::string> write_grid_pieces(const ScratchFolder& scratch, const std::string& folder,
                                                  const Whole& whole, int ranks, std::size_t load_case = 0) {
  const Cut cut(whole.model, deal(whole.model, ranks), ranks);
  FileSet files(scratch / folder);
  std::vector<std::string> paths;
  for (int rank = 0; rank < ranks; ++rank) {
    const Piece piece = cut.piece(rank);
    const std::string name = "model_" + std::to_string(rank) + ".vtu";
    write_grid_piece(files.create(name), piece, restricted(whole.solution, piece).cases[load_case]);
    paths.push_back((scratch / folder / name).string());
  }
  files.commit();
  return paths;
}

}  // namespace bondstatic::test
