#include "multigrid/clumps.hpp"

#include <algorithm>
#include <utility>

#include "multigrid/strength.hpp"

namespace bondstatic::multigrid {

namespace {

// A link is strong if it has this much of the strongest link at one of its two ends.
constexpr float strong_share = 0.25f;

// The links of a packing as clumps see them.
template <class LinkType>
class Ties {
 public:
  Ties(const Packing<LinkType>& packing, int threads)
      : packing_(packing), weight_(packing.links.size()), strongest_(std::size_t(packing.own), 0) {
    const Index links = Index(packing.links.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (Index k = 0; k < links; ++k) weight_[std::size_t(k)] = float(strength(packing.link(k)));
#pragma omp parallel for num_threads(threads) schedule(static)
    for (Index p = 0; p < packing.own; ++p)
      for_each_moving(p, [&](Index k, Index) {
        strongest_[std::size_t(p)] = std::max(strongest_[std::size_t(p)], weight_[std::size_t(k)]);
      });
  }

  /// Calls visit(link, other body) for links to own bodies that can move.
  template <class Visit>
  void for_each(Index body, Visit visit) const {
    for_each_moving(body, [&](Index k, Index other) {
      if (other < packing_.own) visit(k, other);
    });
  }
  template <class Visit>
  void for_each_strong(Index body, Visit visit) const {
    for_each(body, [&](Index k, Index other) {
      const float enough =
          strong_share * std::min(strongest_[std::size_t(body)], strongest_[std::size_t(other)]);
      if (weight_[std::size_t(k)] >= enough) visit(k, other);
    });
  }
  float weight(Index link) const {
    return weight_[std::size_t(link)];
  }
  bool tied(Index body) const {
    return strongest_[std::size_t(body)] > 0;
  }

 private:
  template <class Visit>
  void for_each_moving(Index body, Visit visit) const {
    if (packing_.is_held(body)) return;
    for (const Index k : packing_.incidence->of(body))
      if (const Index other = packing_.other_end(k, body); !packing_.is_held(other)) visit(k, other);
  }

  const Packing<LinkType>& packing_;
  std::vector<float> weight_, strongest_;
};

// Tied bodies, each beside the ones before it.
template <class LinkType>
std::vector<Index> breadth_first(const Ties<LinkType>& ties, Index bodies) {
  std::vector<Index> order;
  order.reserve(std::size_t(bodies));
  std::vector<bool> seen(static_cast<std::size_t>(bodies), false);
  const auto see = [&](Index p) {
    if (seen[std::size_t(p)]) return;
    seen[std::size_t(p)] = true;
    order.push_back(p);
  };
  for (Index start = 0; start < bodies; ++start) {
    if (!ties.tied(start)) continue;
    std::size_t next = order.size();
    for (see(start); next < order.size(); ++next)
      ties.for_each(order[next], [&](Index, Index other) { see(other); });
  }
  return order;
}

std::vector<Index> clumps_among(const std::vector<Index>& bodies, const std::vector<Index>& clump_of) {
  std::vector<Index> found;
  for (const Index p : bodies)
    if (clump_of[std::size_t(p)] != no_clump) found.push_back(clump_of[std::size_t(p)]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// The clumps of copies get numbers behind the own ones, rank by rank and in the order of their owners.
void number_copies(const Halo& halo, Clumps& clumps) {
  refresh(halo, clumps.of);  // of copies, now their owners' numbers
  for (const Neighbour& neighbour : halo.neighbours) {
    Neighbour coarse{neighbour.rank, clumps_among(neighbour.lent, clumps.of), {}};
    const std::vector<Index> theirs = clumps_among(neighbour.borrowed, clumps.of);
    const Index first = clumps.count + clumps.copies;
    for (const Index p : neighbour.borrowed) {
      Index& clump = clumps.of[std::size_t(p)];
      if (clump != no_clump)
        clump = first + (std::lower_bound(theirs.begin(), theirs.end(), clump) - theirs.begin());
    }
    clumps.copies += Index(theirs.size());
    for (Index c = first; c < clumps.count + clumps.copies; ++c) coarse.borrowed.push_back(c);
    clumps.neighbours.push_back(std::move(coarse));
  }
}

}  // namespace

template <class LinkType>
Clumps form_clumps(const Packing<LinkType>& packing, int threads) {
  const Ties<LinkType> ties(packing, threads);
  const std::vector<Index> order = breadth_first(ties, packing.own);
  Clumps clumps{0, std::vector<Index>(std::size_t(packing.bodies), no_clump), 0, {}};
  const auto clump_of = [&](Index p) -> Index& { return clumps.of[std::size_t(p)]; };

  for (const Index p : order) {
    bool alone = clump_of(p) == no_clump;
    if (alone) ties.for_each_strong(p, [&](Index, Index q) { alone = alone && clump_of(q) == no_clump; });
    if (!alone) continue;
    clump_of(p) = clumps.count;
    ties.for_each_strong(p, [&](Index, Index q) { clump_of(q) = clumps.count; });
    ++clumps.count;
  }

  // Every body left has a strong neighbour in one of these clumps, or it would have started one.
  std::vector<std::pair<Index, Index>> joins;
  std::vector<std::pair<Index, float>> pulls;  // clump, sum of weights
  for (const Index p : order) {
    if (clump_of(p) != no_clump) continue;
    pulls.clear();
    ties.for_each_strong(p, [&](Index k, Index q) {
      const Index clump = clump_of(q);
      if (clump == no_clump) return;
      auto pull =
          std::find_if(pulls.begin(), pulls.end(), [clump](const auto& of) { return of.first == clump; });
      if (pull == pulls.end()) pull = pulls.insert(pulls.end(), {clump, 0.0f});
      pull->second += ties.weight(k);
    });
    const auto most = std::max_element(pulls.begin(), pulls.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    joins.emplace_back(p, most->first);
  }
  for (const auto& [p, clump] : joins) clump_of(p) = clump;
  if (packing.halo->ranks) number_copies(*packing.halo, clumps);
  return clumps;
}

Incidence members_of(const Clumps& clumps) {
  Incidence members;
  members.offset.assign(std::size_t(clumps.count) + 1, 0);
  const auto is_own = [&](Index c) { return c != no_clump && c < clumps.count; };
  for (const Index c : clumps.of)
    if (is_own(c)) ++members.offset[std::size_t(c) + 1];
  for (std::size_t c = 0; c < std::size_t(clumps.count); ++c) members.offset[c + 1] += members.offset[c];
  members.link.resize(std::size_t(members.offset.back()));
  std::vector<Index> next(members.offset.begin(), members.offset.end() - 1);
  for (std::size_t p = 0; p < clumps.of.size(); ++p)
    if (is_own(clumps.of[p])) members.link[std::size_t(next[std::size_t(clumps.of[p])]++)] = Index(p);
  return members;
}

template Clumps form_clumps(const Packing<Link>&, int);
template Clumps form_clumps(const Packing<RigidLink<float>>&, int);
template Clumps form_clumps(const Packing<RigidLink<double>>&, int);

}  // namespace bondstatic::multigrid
