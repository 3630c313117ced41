#include "statics/partners.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "system/together.hpp"

namespace bondstatic {

NetworkShare share_of(const Piece& piece, Ranks& ranks) {
  NetworkShare share;
  share.ranks = &ranks;
  share.own = piece.own;
  for (const Particle& particle : piece.model.particles) share.position.push_back(particle.position);
  std::map<int, Neighbour> neighbours;
  const Index bodies = Index(piece.model.particles.size());
  for (Index copy = piece.own; copy < bodies; ++copy)
    neighbours[piece.owner[std::size_t(copy - piece.own)]].borrowed.push_back(copy);
  // Who owns one end of a bond has a copy of the other.
  for (const Bond& bond : piece.model.bonds) {
    if (piece.has(bond.a) == piece.has(bond.b)) continue;
    const Index own = std::min(bond.a, bond.b), copy = std::max(bond.a, bond.b);
    neighbours[piece.owner[std::size_t(copy - piece.own)]].lent.push_back(own);
  }
  const auto number = [&](Index p) { return piece.particle[std::size_t(p)]; };
  for (auto& [rank, neighbour] : neighbours) {
    for (std::vector<Index>* list : {&neighbour.lent, &neighbour.borrowed})
      std::sort(list->begin(), list->end(), [&](Index l, Index r) { return number(l) < number(r); });
    auto& lent = neighbour.lent;
    lent.erase(std::unique(lent.begin(), lent.end()), lent.end());
    neighbour.rank = rank;
    share.neighbours.push_back(std::move(neighbour));
  }
  return share;
}

double rotation_length_of_all(const BondNetwork& share, Ranks& ranks) {
  std::array<Extended, 2> sums{0.0, 0.0};  // of branches, of bonds
  for (const Link& link : share.links) {
    if (!share.owns(link)) continue;
    sums[0] += link.branch.norm();
    sums[1] += 1.0;
  }
  add_up(&ranks, sums);
  return rotation_length(to_double(sums[0]), to_double(sums[1]));
}

std::vector<Index> common_labels(Ranks& ranks, const std::vector<Index>& mine) {
  const std::vector<double> numbers(mine.begin(), mine.end());
  const std::vector<double> all = ranks.all_gather(numbers);
  std::map<std::vector<double>, Index> label;
  std::vector<Index> common;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    std::vector<double> everywhere;
    for (std::size_t at = i; at < all.size(); at += mine.size()) everywhere.push_back(all[at]);
    common.push_back(label.try_emplace(everywhere, Index(label.size())).first->second);
  }
  return common;
}

}  // namespace bondstatic
