// A network cut into the shares of several ranks by hand, for tests.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "mechanism/mechanism_models.hpp"

namespace bondstatic::test {

struct NetPiece {
  Model model;
  NetworkShare share;
  BondNetwork network;  ///< with that share
  FreeDofs dofs;
  std::vector<Index> number;  ///< of each body: its position in the whole
};

/// Own bodies and then copies, each ascending in the whole; the links that touch an own body.
inline std::vector<NetPiece> cut(const Net& net, const std::vector<int>& rank_of, int ranks) {
  const auto rank = [&](Index p) { return rank_of[std::size_t(p)]; };
  std::vector<NetPiece> pieces(static_cast<std::size_t>(ranks));
  for (int r = 0; r < ranks; ++r) {
    NetPiece& piece = pieces[std::size_t(r)];
    std::map<int, std::set<Index>> lent, borrowed;
    std::set<Index> copies;
    for (const Link& link : net.network.links)
      for (const auto& [mine, other] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
        if (rank(mine) != r || rank(other) == r) continue;
        lent[rank(other)].insert(mine);
        borrowed[rank(other)].insert(other);
        copies.insert(other);
      }
    for (Index p = 0; p < net.count(); ++p)
      if (rank(p) == r) piece.number.push_back(p);
    piece.share.own = Index(piece.number.size());
    piece.number.insert(piece.number.end(), copies.begin(), copies.end());

    std::map<Index, Index> local;
    std::vector<std::uint8_t> free;
    for (const Index p : piece.number) {
      local[p] = Index(piece.model.particles.size());
      piece.model.particles.push_back(net.model.particles[std::size_t(p)]);
      piece.share.position.push_back(net.at(p));
      free.push_back(net.free[std::size_t(p)]);
    }
    piece.dofs = number_free_dofs(std::move(free));
    const auto locals = [&](const std::set<Index>& numbers) {
      std::vector<Index> found;
      for (const Index p : numbers) found.push_back(local[p]);
      return found;
    };
    for (const auto& [other, numbers] : lent)
      piece.share.neighbours.push_back({other, locals(numbers), locals(borrowed[other])});
    piece.network.bodies = Index(piece.number.size());
    for (Link link : net.network.links) {
      if (rank(link.a) != r && rank(link.b) != r) continue;
      link.a = local[link.a], link.b = local[link.b];
      piece.network.links.push_back(link);
    }
    piece.network.share = &piece.share;
  }
  return pieces;
}

}  // namespace bondstatic::test
