#include "multigrid/clumps.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "multigrid/strength.hpp"

namespace bondstatic::multigrid {

namespace {

// A link is strong if it has this much of the strongest link at one of its two ends.
constexpr float strong_share = 0.25f;

// What a body is tied to, as clumps see it.
struct Tie {
  std::uint32_t other;  // own body that can move, or nobody
  float weight;
  bool strong;
};
constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

// Ties body by body, one after another in memory: they are walked many times, in the order of the bodies.
class Ties {
 public:
  template <class LinkType>
  Ties(const Packing<LinkType>& packing, int threads)
      : first_(packing.incidence->offset),
        ties_(packing.incidence->link.size()),
        strongest_(std::size_t(packing.own), 0) {
    const Index links = Index(packing.links.size());
    std::vector<float> weight(packing.links.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (Index k = 0; k < links; ++k) weight[std::size_t(k)] = float(strength(packing.link(k)));
#pragma omp parallel for num_threads(threads) schedule(static)
    for (Index p = 0; p < packing.own; ++p) {
      std::size_t at = std::size_t(first_[std::size_t(p)]);
      for (const Index k : packing.incidence->of(p)) {
        const Index other = packing.other_end(k, p);
        const bool moves = !packing.is_held(p) && !packing.is_held(other);
        ties_[at++] = {moves && other < packing.own ? std::uint32_t(other) : nobody, weight[std::size_t(k)],
                       false};
        if (moves) strongest_[std::size_t(p)] = std::max(strongest_[std::size_t(p)], weight[std::size_t(k)]);
      }
    }
#pragma omp parallel for num_threads(threads) schedule(static)
    for (Index p = 0; p < packing.own; ++p)
      for (Tie& tie : of(p))
        if (tie.other != nobody)
          tie.strong =
              tie.weight >= strong_share * std::min(strongest_[std::size_t(p)], strongest_[tie.other]);
  }

  template <class Visit>
  void for_each(Index body, Visit visit) const {
    for (const Tie& tie : of(body))
      if (tie.other != nobody) visit(tie);
  }
  template <class Visit>
  void for_each_strong(Index body, Visit visit) const {
    for (const Tie& tie : of(body))
      if (tie.strong) visit(tie);
  }
  bool tied(Index body) const {
    return strongest_[std::size_t(body)] > 0;
  }

 private:
  std::span<Tie> of(Index body) {
    return {ties_.data() + first_[std::size_t(body)], ties_.data() + first_[std::size_t(body) + 1]};
  }
  std::span<const Tie> of(Index body) const {
    return {ties_.data() + first_[std::size_t(body)], ties_.data() + first_[std::size_t(body) + 1]};
  }

  const std::vector<Index>& first_;
  std::vector<Tie> ties_;
  std::vector<float> strongest_;
};

// Tied bodies, each beside the ones before it.
std::vector<Index> breadth_first(const Ties& ties, Index bodies) {
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
      ties.for_each(order[next], [&](const Tie& tie) { see(tie.other); });
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
  const Ties ties(packing, threads);
  const std::vector<Index> order = breadth_first(ties, packing.own);
  Clumps clumps{0, std::vector<Index>(std::size_t(packing.bodies), no_clump), 0, {}};
  const auto clump_of = [&](Index p) -> Index& { return clumps.of[std::size_t(p)]; };

  for (const Index p : order) {
    bool alone = clump_of(p) == no_clump;
    if (alone)
      ties.for_each_strong(p, [&](const Tie& tie) { alone = alone && clump_of(tie.other) == no_clump; });
    if (!alone) continue;
    clump_of(p) = clumps.count;
    ties.for_each_strong(p, [&](const Tie& tie) { clump_of(tie.other) = clumps.count; });
    ++clumps.count;
  }

  // Every body left has a strong neighbour in one of these clumps, or it would have started one.
  std::vector<std::pair<Index, Index>> joins;
  std::vector<std::pair<Index, float>> pulls;  // clump, sum of weights
  for (const Index p : order) {
    if (clump_of(p) != no_clump) continue;
    pulls.clear();
    ties.for_each_strong(p, [&](const Tie& tie) {
      const Index clump = clump_of(tie.other);
      if (clump == no_clump) return;
      auto pull =
          std::find_if(pulls.begin(), pulls.end(), [clump](const auto& of) { return of.first == clump; });
      if (pull == pulls.end()) pull = pulls.insert(pulls.end(), {clump, 0.0f});
      pull->second += tie.weight;
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
