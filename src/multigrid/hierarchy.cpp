#include "multigrid/hierarchy.hpp"

#include <numeric>

#include "multigrid/coarsen.hpp"

namespace bondstatic::multigrid {

namespace {

// Bodies that are solved at once: a triangular solve with their factor costs no more than a cycle around it.
constexpr Index few_bodies = 64;

template <class LinkType>
void append_copies(const Packing<LinkType>& packing, Numbering& numbering) {
  Index next = Index(numbering.body.size()) + 1;  // the ground comes first
  for (Index p = packing.own; p < packing.bodies; ++p)
    if (!packing.is_held(p)) numbering.row[std::size_t(p)] = next++;
}

// Rows in the order of the bodies.
template <class LinkType>
Numbering number_as_they_come(const Packing<LinkType>& packing) {
  Numbering numbering{std::vector<Index>(std::size_t(packing.bodies), no_row), {}};
  for (Index p = 0; p < packing.own; ++p) {
    if (packing.is_held(p)) continue;
    numbering.row[std::size_t(p)] = Index(numbering.body.size());
    numbering.body.push_back(p);
  }
  append_copies(packing, numbering);
  return numbering;
}

// Clump after clump as the coarser level numbers them, then bodies without a clump.
template <class LinkType>
Numbering number_by_clumps(const Packing<LinkType>& packing, const Clumps& clumps, const Numbering& coarse) {
  const auto own = std::size_t(packing.own);
  const auto bin = [&](std::size_t p) {
    return std::size_t(clumps.of[p] == no_clump ? clumps.count : coarse.row[std::size_t(clumps.of[p])]);
  };
  std::vector<Index> next(std::size_t(clumps.count) + 2, 0);
  for (std::size_t p = 0; p < own; ++p)
    if (!packing.is_held(Index(p))) ++next[bin(p) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  Numbering numbering{std::vector<Index>(std::size_t(packing.bodies), no_row),
                      std::vector<Index>(std::size_t(next.back()))};
  for (std::size_t p = 0; p < own; ++p) {
    if (packing.is_held(Index(p))) continue;
    numbering.row[p] = next[bin(p)]++;
    numbering.body[std::size_t(numbering.row[p])] = Index(p);
  }
  append_copies(packing, numbering);
  return numbering;
}

// Lists of bodies as lists of rows; held bodies are no copies to anybody.
Halo in_rows(const Halo& halo, const Numbering& numbering) {
  Halo rows{halo.ranks, halo.neighbours};
  for (Neighbour& neighbour : rows.neighbours)
    for (std::vector<Index>* list : {&neighbour.lent, &neighbour.borrowed}) {
      for (Index& body : *list) body = numbering.row[std::size_t(body)];
      std::erase(*list, no_row);
    }
  return rows;
}

// `free` by body on the finest level; null above it, where all degrees of freedom are free and springs count.
template <class Scalar, class LinkType>
Level<Scalar> make_level(const Packing<LinkType>& packing, const Numbering& numbering,
                         const std::vector<std::uint8_t>* free, int threads) {
  Level<Scalar> level;
  level.bodies = Index(numbering.body.size());
  level.halo = in_rows(*packing.halo, numbering);
  for (const Neighbour& neighbour : level.halo.neighbours) level.copies += Index(neighbour.borrowed.size());
  level.links = pack_links<Scalar>(packing, numbering, threads);
  level.inverse.resize((numbering.body.size() + pack_size - 1) / pack_size);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (Index row = 0; row < level.bodies; ++row) {
    const Index p = numbering.body[std::size_t(row)];
    Matrix6 block = links_felt_at(packing, p);
    if (const Spring* spring = free ? nullptr : packing.spring_of(p)) block += spring->stiffness;
    const Matrix6 inverse = inverse_block(block, free ? (*free)[std::size_t(p)] : all_free);
    auto& pack = level.inverse[std::size_t(row / pack_size)];
    int entry = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j) pack.c[entry++][row % pack_size] = Scalar(inverse(i, j));
  }
  for (Index row = 0; free && row < level.bodies; ++row)
    if (const std::uint8_t bits = (*free)[std::size_t(numbering.body[std::size_t(row)])]; bits != all_free)
      level.partly_held.push_back({row, bits});
  const auto make = [&] { return make_rows<Scalar>(level.bodies, level.copies, threads); };
  for (Rows<Scalar>* v : {&level.x, &level.r, &level.d, &level.e}) *v = make();
  if (!free)
    for (Rows<Scalar>* v : {&level.given, &level.first, &level.product}) *v = make();
  return level;
}

template <class Scalar>
void place_clumps(const Clumps& clumps, const Numbering& fine, const Numbering& coarse,
                  const std::vector<Vector3>& offsets, Level<Scalar>& level) {
  level.clump_first.assign(std::size_t(clumps.count) + 1, 0);
  for (const Index clump : clumps.of)
    if (clump != no_clump && clump < clumps.count)
      ++level.clump_first[std::size_t(coarse.row[std::size_t(clump)]) + 1];
  std::partial_sum(level.clump_first.begin(), level.clump_first.end(), level.clump_first.begin());
  level.offset.resize(fine.body.size());
  for (std::size_t row = 0; row < fine.body.size(); ++row) {
    const Vector3& offset = offsets[std::size_t(fine.body[row])];
    level.offset[row] = {Scalar(offset.x()), Scalar(offset.y()), Scalar(offset.z())};
  }
}

}  // namespace

template <class Scalar>
Hierarchy<Scalar> build_hierarchy(const BondNetwork& network, const Incidence& incidence,
                                  const FreeDofs& dofs, int threads, Plan& plan) {
  const bool planned = !plan.numbering.empty();
  std::vector<Spring> springs;
  Halo halo;
  const Packing<Link> finest = finest_packing(network, incidence, dofs, springs, halo);

  // 1. Coarsen until few bodies are left, or nothing that could be put together.
  std::vector<CoarsePacking<Scalar>> coarse;
  std::vector<std::vector<Vector3>> offsets;
  const auto coarsen_once = [&](const auto& packing) {
    const std::size_t l = coarse.size();
    const Index bodies = over_all_ranks(halo, packing.own);
    if (bodies <= few_bodies) return false;
    if (!planned) plan.clumps.push_back(form_clumps(packing, threads));
    if (plan.clumps.size() == l) return false;
    const Index clumps = over_all_ranks(halo, plan.clumps[l].count);
    if (clumps == 0 || clumps == bodies) {
      plan.clumps.pop_back();
      return false;
    }
    offsets.push_back(offsets_in_clumps(packing, plan.clumps[l], threads));
    coarse.push_back(coarsen<Scalar>(packing, plan.clumps[l], offsets[l], threads));
    return true;
  };
  for (bool more = coarsen_once(finest); more;) more = coarsen_once(coarse.back().view());
  const std::size_t last = coarse.size();

  // 2. Number the rows from the coarsest level down.
  if (!planned) {
    plan.numbering.resize(last + 1);
    for (std::size_t l = last + 1; l-- > 0;) {
      const auto number = [&](const auto& packing) {
        return l == last ? number_as_they_come(packing)
                         : number_by_clumps(packing, plan.clumps[l], plan.numbering[l + 1]);
      };
      plan.numbering[l] = l == 0 ? number(finest) : number(coarse[l - 1].view());
    }
  }

  // 3. Pack each level's links and invert its diagonal blocks; factorise the coarsest.
  Hierarchy<Scalar> hierarchy;
  hierarchy.units = finest.units;
  hierarchy.levels.push_back(make_level<Scalar>(finest, plan.numbering[0], &dofs.free, threads));
  if (last == 0)
    hierarchy.coarsest.factorise(finest, plan.numbering[0], hierarchy.levels[0].halo,
                                 hierarchy.levels[0].partly_held);
  for (std::size_t l = 0; l < last; ++l) {
    place_clumps(plan.clumps[l], plan.numbering[l], plan.numbering[l + 1], offsets[l], hierarchy.levels[l]);
    const auto packing = coarse[l].view();
    hierarchy.levels.push_back(make_level<Scalar>(packing, plan.numbering[l + 1], nullptr, threads));
    if (l + 1 == last)
      hierarchy.coarsest.factorise(packing, plan.numbering[last], hierarchy.levels[last].halo, {});
    offsets[l] = {};
    coarse[l] = {};
  }
  return hierarchy;
}

template Hierarchy<float> build_hierarchy(const BondNetwork&, const Incidence&, const FreeDofs&, int, Plan&);
template Hierarchy<double> build_hierarchy(const BondNetwork&, const Incidence&, const FreeDofs&, int, Plan&);

}  // namespace bondstatic::multigrid
