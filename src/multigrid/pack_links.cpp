#include <algorithm>
#include <type_traits>

#include "multigrid/link_packs.hpp"

namespace bondstatic::multigrid {

namespace {

// `turned`: a and b change places. Motions, forces and e then all change sign, and so does what couples them
// by a cross product with e.
template <class Scalar>
void put(const Link& link, bool turned, int lane, RoundPack<Scalar>& pack) {
  const double length = link.branch.norm(), sign = turned ? -1 : 1;
  const double share = turned ? 1 - link.fraction : link.fraction;
  for (int i = 0; i < 3; ++i) pack.axis[i][lane] = Scalar(sign * link.branch[i] / length);
  pack.ta[lane] = Scalar(share * length);
  pack.tb[lane] = Scalar((1 - share) * length);
  pack.kn[lane] = Scalar(link.stiffness.kn);
  pack.ks[lane] = Scalar(link.stiffness.ks);
  pack.kt[lane] = Scalar(link.stiffness.kt);
  pack.kb[lane] = Scalar(link.stiffness.kb);
  pack.coupling[lane] = Scalar(sign * link.stiffness.coupling);
}

template <class Scalar>
void put(const RigidLink<Scalar>& link, bool turned, int lane, FullPack<Scalar>& pack) {
  for (int i = 0; i < 3; ++i) {
    pack.arm_a[i][lane] = (turned ? link.arm_b : link.arm_a)[i];
    pack.arm_b[i][lane] = (turned ? link.arm_a : link.arm_b)[i];
  }
  int entry = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) pack.c[entry++][lane] = link.stiffness(i, j);
}

// A link and the rows of its two ends.
struct Placed {
  Index link, a, b;
  bool turned;
};

// Lanes that are left over stay zero and join `row` to itself.
template <class Pack, class LinkType>
std::vector<Pack> filled(const Packing<LinkType>& packing, const std::vector<Placed>& placed, Index row) {
  std::vector<Pack> packs((placed.size() + pack_size - 1) / pack_size);
  for (std::size_t k = 0; k < packs.size() * pack_size; ++k) {
    Pack& pack = packs[k / pack_size];
    const int lane = int(k % pack_size);
    const bool real = k < placed.size();
    pack.a[lane] = std::uint32_t(real ? placed[k].a : row);
    pack.b[lane] = std::uint32_t(real ? placed[k].b : row);
    if (real) put(packing.link(placed[k].link), placed[k].turned, lane, pack);
  }
  return packs;
}

// Springs of the block's bodies, as links to the ground at their own centres.
template <class Scalar>
void append_springs(const Packing<RigidLink<Scalar>>& packing, const Numbering& numbering,
                    Block<FullPack<Scalar>>& block) {
  int lane = pack_size;
  for (Index row = block.first; row < block.last; ++row) {
    const Spring* spring = packing.spring_of(numbering.body[std::size_t(row)]);
    if (!spring) continue;
    if (lane == pack_size) {
      block.across.emplace_back();
      std::fill_n(block.across.back().a, pack_size, std::uint32_t(block.first));
      std::fill_n(block.across.back().b, pack_size, std::uint32_t(block.first));
      lane = 0;
    }
    FullPack<Scalar>& pack = block.across.back();
    pack.a[lane] = std::uint32_t(row);
    pack.b[lane] = std::uint32_t(numbering.body.size());
    const Vector3T<Scalar> none = Vector3T<Scalar>::Zero();
    put(RigidLink<Scalar>{0, 0, none, none, spring->stiffness.template cast<Scalar>()}, false, lane++, pack);
  }
}

}  // namespace

template <class Scalar, class LinkType>
std::vector<Block<typename PackOf<LinkType, Scalar>::Type>> pack_links(const Packing<LinkType>& packing,
                                                                       const Numbering& numbering,
                                                                       int threads) {
  using Pack = typename PackOf<LinkType, Scalar>::Type;
  const Index rows = Index(numbering.body.size()), count = (rows + block_size - 1) / block_size;
  std::vector<Block<Pack>> blocks(static_cast<std::size_t>(count));
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (Index n = 0; n < count; ++n) {
    Block<Pack>& block = blocks[std::size_t(n)];
    block.first = n * block_size;
    block.last = std::min(rows, block.first + block_size);
    std::vector<Placed> inside, across;
    for (Index row = block.first; row < block.last; ++row) {
      const Index p = numbering.body[std::size_t(row)];
      for (const Index k : packing.incidence->of(p)) {
        const Index other = numbering.row[std::size_t(packing.other_end(k, p))];
        const bool turned = packing.links[std::size_t(k)].a != p;
        if (other < block.first || other >= block.last)
          across.push_back({k, row, other == no_row ? rows : other, turned});
        else if (row < other)
          inside.push_back({k, row, other, turned});
      }
    }
    block.inside = filled<Pack>(packing, inside, block.first);
    block.across = filled<Pack>(packing, across, block.first);
    if constexpr (!std::is_same_v<LinkType, Link>) append_springs(packing, numbering, block);
  }
  return blocks;
}

template std::vector<Block<RoundPack<float>>> pack_links<float>(const Packing<Link>&, const Numbering&, int);
template std::vector<Block<RoundPack<double>>> pack_links<double>(const Packing<Link>&, const Numbering&,
                                                                  int);
template std::vector<Block<FullPack<float>>> pack_links<float>(const Packing<RigidLink<float>>&,
                                                               const Numbering&, int);
template std::vector<Block<FullPack<double>>> pack_links<double>(const Packing<RigidLink<double>>&,
                                                                 const Numbering&, int);

}  // namespace bondstatic::multigrid
