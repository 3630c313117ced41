// What of a piece is its rank's own, for results that stand once whatever the number of ranks.
#pragma once

#include <vector>

#include "model/piece.hpp"

namespace bondstatic {

/// Positions in the piece of the bonds that it owns, ascending.
inline std::vector<Index> owned_bonds(const Piece& piece) {
  std::vector<Index> owned;
  for (std::size_t k = 0; k < piece.model.bonds.size(); ++k)
    if (piece.owns(piece.model.bonds[k])) owned.push_back(Index(k));
  return owned;
}

}  // namespace bondstatic
