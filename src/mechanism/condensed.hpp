// Mechanisms of a network that lies in pieces, one a rank, without any rank that holds the whole: each rank
// contracts its share to what the others must know, and one of them puts the contracted shares together.
//
// What rigid links unite moves as one, whoever looks at it. Hence a body may go where nothing but such a set
// knows it; the others of its set stay tied to each other. The condensed network has the same rigid sets,
// joints and supports as the whole, and so it has a mechanism if and only if the whole has one, with as many
// independent motions.
//
// Kept are the bodies at the cut, those held, those at links that are not rigid, and two of each set. A
// welded packing shrinks to its cut surface, n^(2/3) of n bodies. A network without moments anywhere does not
// shrink: then all of it comes together in one place. A kept body takes 41 bytes and its tie 88, a link that
// is not rigid 88. condense() and spread() take linear time (0.06 s for 500,000 bodies with 1,500,000 welds;
// 0.3 s where every third is a hinge) and at most 100 bytes a body beside the share and the result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/network.hpp"
#include "io/archive.hpp"

namespace bondstatic {

/// What the other ranks must know of one rank's share.
struct Condensed {
  Index own = 0;                   ///< bodies 0 ... own-1 are the rank's, the others are copies
  std::vector<Index> number;       ///< of each kept body, in the numbering of all ranks
  std::vector<Vector3> position;   ///< of each kept body
  std::vector<double> radius;      ///< of each kept body
  std::vector<std::uint8_t> free;  ///< of each kept body, as in FreeDofs
  /// Between kept bodies: those of the share that are not rigid, each from the rank that owns it, and rigid
  /// ties that keep together what the rank has united.
  std::vector<Link> links;
};

void describe(Archive& archive, Condensed& condensed);

/// Of a share, or of a whole network. `model` has the particles of the share's bodies in their order;
/// `number` of each body, copies included, in the numbering of all ranks.
Condensed condense(const BondNetwork& network, const FreeDofs& dofs, const Model& model,
                   std::span<const Index> number);

/// A network of the bodies that all ranks have kept, for find_mechanisms and unsupported_bodies.
struct Assembled {
  Model model;  ///< particles only; the id of each is its number among all ranks
  BondNetwork network;
  FreeDofs dofs;
  std::vector<Index> number;  ///< of each body, ascending
};

/// From the condensed shares of all ranks. Of a body that several know its owner's mask of free dofs counts.
Assembled assemble_condensed(std::span<const Condensed> pieces);

/// The way back to the bodies of a share: which of the `groups` of numbers of condensed bodies each one
/// belongs to, because it is named there or is united with one that is; -1 where none. Groups must not tear
/// united bodies apart (those of unsupported_bodies do not, nor the particles of one mechanism).
std::vector<Index> spread(const BondNetwork& network, const Model& model, std::span<const Index> number,
                          std::span<const std::vector<Index>> groups);

}  // namespace bondstatic
