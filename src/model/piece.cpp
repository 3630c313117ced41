#include "model/piece.hpp"

#include <algorithm>
#include <span>

namespace bondstatic {

namespace {

// Items listed by group, ascending within each.
struct Groups {
  std::vector<Index> first, item;

  std::span<const Index> of(Index group) const {
    const auto begin = std::size_t(first[std::size_t(group)]),
               end = std::size_t(first[std::size_t(group) + 1]);
    return {item.data() + begin, end - begin};
  }
};

// groups_of(i, put) calls put(group) for each group that item i belongs to.
template <class GroupsOf>
Groups group(Index groups, Index items, GroupsOf groups_of) {
  Groups all;
  all.first.assign(std::size_t(groups) + 1, 0);
  for (Index i = 0; i < items; ++i) groups_of(i, [&](Index g) { ++all.first[std::size_t(g) + 1]; });
  for (std::size_t g = 0; g < std::size_t(groups); ++g) all.first[g + 1] += all.first[g];
  all.item.resize(std::size_t(all.first.back()));
  std::vector<Index> next(all.first.begin(), all.first.end() - 1);
  for (Index i = 0; i < items; ++i)
    groups_of(i, [&](Index g) { all.item[std::size_t(next[std::size_t(g)]++)] = i; });
  return all;
}

template <class Item>
Groups by_particle(const Model& model, const std::vector<Item>& items) {
  return group(Index(model.particles.size()), Index(items.size()),
               [&](Index i, auto put) { put(items[std::size_t(i)].particle); });
}

}  // namespace

struct Cut::Lists {
  std::vector<int> rank_of;
  Groups particles, bonds;    // by rank; a bond that crosses is in two
  Groups supports, loads;     // by particle
  std::vector<Index> in_own;  // of each particle: its number among its rank's own

  Lists(const Model& model, std::vector<int> ranks_of, int ranks)
      : rank_of(std::move(ranks_of)),
        particles(
            group(ranks, Index(rank_of.size()), [&](Index p, auto put) { put(rank_of[std::size_t(p)]); })),
        bonds(group(ranks, Index(model.bonds.size()),
                    [&](Index k, auto put) {
                      const Bond& bond = model.bonds[std::size_t(k)];
                      const int a = rank_of[std::size_t(bond.a)], b = rank_of[std::size_t(bond.b)];
                      put(a);
                      if (b != a) put(b);
                    })),
        supports(by_particle(model, model.supports)),
        loads(by_particle(model, model.loads)),
        in_own(rank_of.size()) {
    for (int r = 0; r < ranks; ++r) {
      Index next = 0;
      for (const Index p : particles.of(r)) in_own[std::size_t(p)] = next++;
    }
  }
};

Cut::Cut(const Model& model, std::vector<int> rank_of, int ranks)
    : model_(model), lists_(std::make_unique<Lists>(model, std::move(rank_of), ranks)) {}

Cut::~Cut() = default;

namespace {

// Numbers of the bonds' far ends that are not the rank's own, ascending.
std::vector<Index> copies(const Model& model, const std::vector<int>& rank_of, std::span<const Index> bonds,
                          int rank) {
  std::vector<Index> found;
  for (const Index k : bonds)
    for (const Index p : {model.bonds[std::size_t(k)].a, model.bonds[std::size_t(k)].b})
      if (rank_of[std::size_t(p)] != rank) found.push_back(p);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Those of the items that concern the piece's particles, in the order of the whole model.
template <class Item, class Local>
std::vector<Item> chosen(const std::vector<Item>& items, const Groups& of_particle,
                         const std::vector<Index>& particles, Local local) {
  std::vector<Index> numbers;
  for (const Index p : particles) {
    const auto here = of_particle.of(p);
    numbers.insert(numbers.end(), here.begin(), here.end());
  }
  std::sort(numbers.begin(), numbers.end());
  std::vector<Item> found;
  for (const Index i : numbers) {
    found.push_back(items[std::size_t(i)]);
    found.back().particle = local(found.back().particle);
  }
  return found;
}

// Blocks keep their place; of their columns the piece's bonds remain.
void choose_bonds(const Model& whole, const std::vector<Index>& bonds, Model& piece) {
  for (const BondBlock& block : whole.blocks) {
    piece.blocks.push_back(block);
    for (auto& [parameter, column] : piece.blocks.back().overrides) column.clear();
    piece.blocks.back().fractions.clear();
  }
  std::vector<Index> count(whole.blocks.size(), 0);
  for (const Index k : bonds) {
    Bond bond = whole.bonds[std::size_t(k)];
    const BondBlock& from = whole.blocks[std::size_t(bond.block)];
    BondBlock& to = piece.blocks[std::size_t(bond.block)];
    for (const auto& [parameter, column] : from.overrides)
      to.overrides[parameter].push_back(column[std::size_t(bond.in_block)]);
    if (!from.fractions.empty()) to.fractions.push_back(from.fractions[std::size_t(bond.in_block)]);
    bond.in_block = count[std::size_t(bond.block)]++;
    piece.bonds.push_back(bond);
  }
}

}  // namespace

Piece Cut::piece(int rank) const {
  const Lists& lists = *lists_;
  Piece piece;
  const auto own = lists.particles.of(rank), bonds = lists.bonds.of(rank);
  const std::vector<Index> others = copies(model_, lists.rank_of, bonds, rank);
  const auto local = [&](Index p) {
    if (lists.rank_of[std::size_t(p)] == rank) return lists.in_own[std::size_t(p)];
    return Index(own.size()) + (std::lower_bound(others.begin(), others.end(), p) - others.begin());
  };
  piece.own = Index(own.size());
  piece.particle.assign(own.begin(), own.end());
  piece.particle.insert(piece.particle.end(), others.begin(), others.end());
  for (const Index p : others) piece.owner.push_back(lists.rank_of[std::size_t(p)]);
  for (const Index p : piece.particle) piece.model.particles.push_back(model_.particles[std::size_t(p)]);
  piece.bond.assign(bonds.begin(), bonds.end());
  choose_bonds(model_, piece.bond, piece.model);
  for (Bond& bond : piece.model.bonds) bond.a = local(bond.a), bond.b = local(bond.b);
  piece.model.supports = chosen(model_.supports, lists.supports, piece.particle, local);
  piece.model.loads = chosen(model_.loads, lists.loads, piece.particle, local);
  piece.model.load_cases = model_.load_cases;
  piece.model.cell = model_.cell;
  piece.model.strains = model_.strains;
  return piece;
}

}  // namespace bondstatic
