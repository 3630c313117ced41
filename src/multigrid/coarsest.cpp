#include "multigrid/coarsest.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace bondstatic::multigrid {

namespace {

// G(arm) of rigid_link.hpp.
Matrix6 motion_at(const Vector3& arm) {
  Matrix6 g = Matrix6::Identity();
  g.topRightCorner<3, 3>() = -cross_matrix(arm);
  return g;
}

// Entries of all ranks, in their order, on all of them.
template <class Triplets>
Triplets entries_of_all(Ranks& ranks, const Triplets& mine) {
  struct Entry {
    Index row, column;
    double value;
  };
  std::string bytes;
  for (const auto& entry : mine) {
    const Entry plain{entry.row(), entry.col(), entry.value()};
    bytes.append(reinterpret_cast<const char*>(&plain), sizeof plain);
  }
  std::string all;
  for (const std::string& part : ranks.gather(bytes)) all += part;
  all = ranks.broadcast(all);
  Triplets entries;
  for (std::size_t at = 0; at < all.size(); at += sizeof(Entry)) {
    Entry plain;
    std::memcpy(&plain, all.data() + at, sizeof plain);
    entries.emplace_back(plain.row, plain.column, plain.value);
  }
  return entries;
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

Eigen::VectorXd Coarsest::of_all(const Halo& halo, const Eigen::VectorXd& mine) const {
  if (!halo.ranks) return mine;
  const Index most = 6 * *std::max_element(rows_of_.begin(), rows_of_.end());
  std::vector<double> padded(mine.begin(), mine.end());
  padded.resize(std::size_t(most));
  const std::vector<double> all = halo.ranks->all_gather(padded);
  Eigen::VectorXd together(unknowns_);
  Index at = 0;
  for (std::size_t rank = 0; rank < rows_of_.size(); ++rank)
    for (Index i = 0; i < 6 * rows_of_[rank]; ++i)
      together[at++] = all[rank * std::size_t(most) + std::size_t(i)];
  return together;
}

template <class LinkType>
void Coarsest::factorise(const Packing<LinkType>& packing, const Numbering& numbering, const Halo& rows,
                         const std::vector<PartlyHeld>& partly_held) {
  const Index own = Index(numbering.body.size());
  number_rows(rows, own);
  // Of each row, the ground's and those of copies as well: its number among all, and what is free.
  std::size_t places = std::size_t(own) + 1;
  for (const Neighbour& neighbour : rows.neighbours) places += neighbour.borrowed.size();
  std::vector<Index> number(places, no_row);
  std::vector<std::uint8_t> free(places, all_free);
  for (Index row = 0; row < own; ++row) number[std::size_t(row)] = first_row_ + row;
  for (const PartlyHeld& body : partly_held) free[std::size_t(body.row)] = body.free;
  refresh(rows, number);
  refresh(rows, free);

  Triplets entries;
  const auto add = [&](Index a, Index b, const Matrix6& block) {
    if (a == no_row || b == no_row || a >= own) return;  // a copy's row is its owner's
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (((free[std::size_t(a)] >> i) & 1) && ((free[std::size_t(b)] >> j) & 1))
          entries.emplace_back(6 * number[std::size_t(a)] + i, 6 * number[std::size_t(b)] + j, block(i, j));
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
      if (!((body.free >> i) & 1)) {
        const Index at = 6 * number[std::size_t(body.row)] + i;
        entries.emplace_back(at, at, 1.0);
      }
  factorise(rows.ranks ? entries_of_all(*rows.ranks, entries) : entries);
}

void Coarsest::number_rows(const Halo& halo, Index own) {
  rows_of_.assign(1, own);
  first_row_ = 0;
  if (halo.ranks) {
    const double mine = double(own);
    const std::vector<double> all = halo.ranks->all_gather({&mine, 1});
    rows_of_.assign(all.begin(), all.end());
    for (int r = 0; r < halo.ranks->rank(); ++r) first_row_ += rows_of_[std::size_t(r)];
  }
  unknowns_ = 6 * std::accumulate(rows_of_.begin(), rows_of_.end(), Index{0});
}

template void Coarsest::factorise(const Packing<Link>&, const Numbering&, const Halo&,
                                  const std::vector<PartlyHeld>&);
template void Coarsest::factorise(const Packing<RigidLink<float>>&, const Numbering&, const Halo&,
                                  const std::vector<PartlyHeld>&);
template void Coarsest::factorise(const Packing<RigidLink<double>>&, const Numbering&, const Halo&,
                                  const std::vector<PartlyHeld>&);

}  // namespace bondstatic::multigrid
