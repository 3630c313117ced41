// A model cut into pieces, one a rank of a run of several: each particle belongs to one of them, and each
// rank gets the bonds that touch its own particles with copies of the particles at their far ends.
#pragma once

#include <memory>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

class Archive;

struct Piece {
  /// Own particles first, then the copies. Supports and loads are in the order of the whole model, those of
  /// copies among them.
  Model model;
  Index own = 0;                ///< particles 0 ... own-1 are this rank's
  std::vector<Index> particle;  ///< of each particle: its position in the whole model
  std::vector<Index> bond;      ///< of each bond, likewise
  std::vector<int> owner;       ///< of each copy: the rank that it belongs to

  bool has(Index local) const { return local < own; }
  /// Of those who hold a bond, one owns it.
  bool owns(const Bond& b) const { return has(b.a); }
};

/// Makes the pieces of a model one by one: the work for a piece grows with the piece.
class Cut {
 public:
  /// `rank_of`: of each particle. The model must outlive this.
  Cut(const Model& model, std::vector<int> rank_of, int ranks);
  ~Cut();
  /// Its own particles, its copies and its bonds are in the order of the whole model.
  Piece piece(int rank) const;

 private:
  struct Lists;
  const Model& model_;
  std::unique_ptr<const Lists> lists_;
};

/// Bit for bit, so that a piece can travel.
void describe(Archive& archive, Piece& piece);

}  // namespace bondstatic
