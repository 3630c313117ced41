#include "multigrid/coarsest.hpp"

namespace bondstatic::multigrid {

namespace {

// G(arm) of rigid_link.hpp.
Matrix6 motion_at(const Vector3& arm) {
  Matrix6 g = Matrix6::Identity();
  g.topRightCorner<3, 3>() = -cross_matrix(arm);
  return g;
}

}  // namespace

void Coarsest::factorise(const Triplets& entries) {
  Matrix k(unknowns_, unknowns_);
  k.setFromTriplets(entries.begin(), entries.end());
  // A motion that float has lost the stiffness of must not end in a division by zero.
  constexpr double rounding = 1e-14;
  for (Index i = 0; i < unknowns_; ++i) k.coeffRef(i, i) *= 1 + rounding;
  factor_ = std::make_unique<typename decltype(factor_)::element_type>(k);
}

template <class LinkType>
void Coarsest::factorise(const Packing<LinkType>& packing, const Numbering& numbering,
                         const std::vector<PartlyHeld>& partly_held) {
  unknowns_ = 6 * Index(numbering.body.size());
  std::vector<std::uint8_t> free(numbering.body.size(), all_free);
  for (const PartlyHeld& body : partly_held) free[std::size_t(body.row)] = body.free;
  Triplets entries;
  const auto add = [&](Index a, Index b, const Matrix6& block) {
    if (a == no_row || b == no_row) return;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (((free[std::size_t(a)] >> i) & 1) && ((free[std::size_t(b)] >> j) & 1))
          entries.emplace_back(6 * a + i, 6 * b + j, block(i, j));
  };
  for (Index n = 0; n < Index(packing.links.size()); ++n) {
    const auto& link = packing.link(n);
    const Index a = numbering.row[std::size_t(link.a)], b = numbering.row[std::size_t(link.b)];
    const Matrix6 ga = motion_at(arm_a(link)), gb = motion_at(arm_b(link));
    const Matrix6 c = stiffness_of(link), across = -ga.transpose() * c * gb;
    add(a, a, ga.transpose() * c * ga);
    add(b, b, gb.transpose() * c * gb);
    add(a, b, across);
    add(b, a, across.transpose());
  }
  if (partly_held.empty())
    for (const Spring& spring : packing.springs) {
      const Index row = numbering.row[std::size_t(spring.body)];
      add(row, row, spring.stiffness);
    }
  for (const PartlyHeld& body : partly_held)
    for (Index i = 0; i < 6; ++i)
      if (!((body.free >> i) & 1)) entries.emplace_back(6 * body.row + i, 6 * body.row + i, 1.0);
  factorise(entries);
}

template void Coarsest::factorise(const Packing<Link>&, const Numbering&, const std::vector<PartlyHeld>&);
template void Coarsest::factorise(const Packing<RigidLink<float>>&, const Numbering&,
                                  const std::vector<PartlyHeld>&);
template void Coarsest::factorise(const Packing<RigidLink<double>>&, const Numbering&,
                                  const std::vector<PartlyHeld>&);

}  // namespace bondstatic::multigrid
