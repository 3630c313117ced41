// A solve that is one rank's part of a run of several.
#pragma once

#include <functional>

#include "bondstatic/network.hpp"
#include "bondstatic/statics.hpp"
#include "model/piece.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct Partners {
  const Piece& piece;
  Ranks& ranks;
  /// Asked at rank 0 only, where a mechanism must be named: which particles move, only the whole model tells.
  std::function<Model()> whole;
};

/// Null without partners.
inline Ranks* ranks_of(const Partners* partners) {
  return partners ? &partners->ranks : nullptr;
}

/// What the network of a piece shares with those of other ranks.
NetworkShare share_of(const Piece& piece, Ranks& ranks);

/// Of the whole network, each bond counted by the rank that owns it.
double rotation_length_of_all(const BondNetwork& share, Ranks& ranks);

/// The same numbers on all ranks where numbers are the same in two places on all ranks: a grouping that is
/// fine enough for every rank.
std::vector<Index> common_labels(Ranks& ranks, const std::vector<Index>& mine);

/// By all ranks together, each with its piece of one model. Of the solution states hold what this rank has,
/// in the piece's numbering; reactions are those of own particles; energy, work, accuracy and report are
/// those of all, phases rank 0's. Throws as solve_statics() does, not always on all ranks: to be called
/// between Ranks::agree().
StaticSolution solve_statics(const Partners& partners, const StaticOptions& options);

}  // namespace bondstatic
