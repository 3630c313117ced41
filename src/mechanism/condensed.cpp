#include "mechanism/condensed.hpp"

#include <algorithm>
#include <utility>

#include "mechanism/constraint.hpp"
#include "mechanism/partition.hpp"

namespace bondstatic {

namespace {

const Vector3& position(const Model& model, Index p) {
  return model.particles[std::size_t(p)].position;
}

bool is_rigid(const Link& link, const Model& model) {
  return is_rigid(link, position(model, link.a), position(model, link.b));
}

Partition rigid_sets(const BondNetwork& network, const Model& model) {
  Partition sets(network.bodies);
  for (const Link& link : network.links)
    if (is_rigid(link, model)) sets.unite(link.a, link.b);
  return sets;
}

// Bodies of which more is known than the rigid set that they belong to.
std::vector<bool> known_otherwise(const BondNetwork& network, const FreeDofs& dofs, const Model& model) {
  constexpr std::uint8_t all_free = 0b111111;
  std::vector<bool> known(std::size_t(network.bodies), false);
  for (const Link& link : network.links)
    if (!is_rigid(link, model)) known[std::size_t(link.a)] = known[std::size_t(link.b)] = true;
  for (std::size_t p = 0; p < known.size(); ++p)
    if ((dofs.free[p] & all_free) != all_free) known[p] = true;
  std::fill(known.begin() + std::ptrdiff_t(network.own()), known.end(), true);
  if (network.share)
    for (const Neighbour& neighbour : network.share->neighbours)
      for (const Index p : neighbour.lent) known[std::size_t(p)] = true;
  return known;
}

// Keeps two bodies of a set or more and ties them to the first one that is known otherwise. One would do for
// the mechanisms; the one farthest from it makes the set about as large as it was, so that lever arms are
// measured, and rounding told from motion, as in the whole network.
void keep_set(const std::vector<Index>& set, const Model& model, std::vector<bool>& kept,
              std::vector<Link>& ties) {
  constexpr SectionStiffness rigid{1, 1, 1, 1, 0};
  const auto is_kept = [&](Index p) { return kept[std::size_t(p)]; };
  const auto first = std::find_if(set.begin(), set.end(), is_kept);
  const Index hub = first == set.end() ? set.front() : *first;
  const auto distance = [&](Index p) { return (position(model, p) - position(model, hub)).squaredNorm(); };
  const Index farthest =
      *std::max_element(set.begin(), set.end(), [&](Index p, Index q) { return distance(p) < distance(q); });
  kept[std::size_t(hub)] = kept[std::size_t(farthest)] = true;
  for (const Index p : set)
    if (p != hub && is_kept(p))
      ties.push_back({hub, p, position(model, p) - position(model, hub), 0.5, rigid});
}

}  // namespace

void describe(Archive& archive, SectionStiffness& c) {
  archive(c.kn, c.ks, c.kt, c.kb, c.coupling);
}

void describe(Archive& archive, Link& link) {
  archive(link.a, link.b, link.branch, link.fraction, link.stiffness);
}

void describe(Archive& archive, Condensed& c) {
  archive(c.own, c.number, c.position, c.radius, c.free, c.links);
}

Condensed condense(const BondNetwork& network, const FreeDofs& dofs, const Model& model,
                   std::span<const Index> number) {
  Condensed condensed;
  std::vector<bool> kept = known_otherwise(network, dofs, model);
  for (const auto& set : rigid_sets(network, model).members([](Index) { return true; }))
    keep_set(set, model, kept, condensed.links);
  for (const Link& link : network.links)
    if (network.owns(link) && !is_rigid(link, model)) condensed.links.push_back(link);

  std::vector<Index> place(kept.size(), -1);
  for (std::size_t p = 0; p < kept.size(); ++p) {
    if (!kept[p]) continue;
    place[p] = Index(condensed.number.size());
    condensed.own += Index(p) < network.own();
    condensed.number.push_back(number[p]);
    condensed.position.push_back(model.particles[p].position);
    condensed.radius.push_back(model.particles[p].radius);
    condensed.free.push_back(dofs.free[p]);
  }
  for (Link& link : condensed.links) link.a = place[std::size_t(link.a)], link.b = place[std::size_t(link.b)];
  return condensed;
}

Assembled assemble_condensed(std::span<const Condensed> pieces) {
  Assembled all;
  std::vector<Index>& number = all.number;
  for (const Condensed& piece : pieces) number.insert(number.end(), piece.number.begin(), piece.number.end());
  std::sort(number.begin(), number.end());
  number.erase(std::unique(number.begin(), number.end()), number.end());
  all.network.bodies = Index(number.size());
  all.model.particles.resize(number.size());
  std::vector<std::uint8_t> free(number.size(), 0b111111);
  for (const Condensed& piece : pieces) {
    std::vector<Index> place;
    for (std::size_t i = 0; i < piece.number.size(); ++i) {
      const auto at =
          std::size_t(std::lower_bound(number.begin(), number.end(), piece.number[i]) - number.begin());
      place.push_back(Index(at));
      all.model.particles[at] = {
          .id = piece.number[i], .position = piece.position[i], .radius = piece.radius[i]};
      if (Index(i) < piece.own) free[at] = piece.free[i];
    }
    for (Link link : piece.links) {
      link.a = place[std::size_t(link.a)], link.b = place[std::size_t(link.b)];
      all.network.links.push_back(link);
    }
  }
  all.dofs = number_free_dofs(std::move(free));
  return all;
}

std::vector<Index> spread(const BondNetwork& network, const Model& model, std::span<const Index> number,
                          std::span<const std::vector<Index>> groups) {
  std::vector<std::pair<Index, Index>> named;  // number, group
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const Index n : groups[g]) named.emplace_back(n, Index(g));
  std::sort(named.begin(), named.end());
  Partition sets = rigid_sets(network, model);
  std::vector<Index> of_set(number.size(), -1), group;
  for (std::size_t p = 0; p < number.size(); ++p) {
    const auto found = std::lower_bound(named.begin(), named.end(), std::pair(number[p], Index(0)));
    if (found != named.end() && found->first == number[p])
      of_set[std::size_t(sets.find(Index(p)))] = found->second;
  }
  for (std::size_t p = 0; p < number.size(); ++p) group.push_back(of_set[std::size_t(sets.find(Index(p)))]);
  return group;
}

}  // namespace bondstatic
