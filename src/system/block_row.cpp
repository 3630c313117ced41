#include "system/block_row.hpp"

#include <algorithm>

namespace bondstatic {

namespace {

Vector6 free_ones(const FreeDofs& dofs, Index body) {
  Vector6 mask;
  for (int i = 0; i < 6; ++i) mask[i] = dofs.is_free(body, i) ? 1 : 0;
  return mask;
}

Matrix6& block_of(BlockRow& row, Index body) {
  for (auto& [q, block] : row)
    if (q == body) return block;
  return row.emplace_back(body, Matrix6::Zero()).second;
}

}  // namespace

void block_row(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs, Index body,
               BlockRow& row) {
  Vector6 scale = Vector6::Ones();
  scale.tail<3>().setConstant(1 / network.rotation_length);
  row.clear();
  block_of(row, body);
  for (const Index index : incidence.of(body)) {
    const Link& link = network.links[std::size_t(index)];
    const Matrix12 k = stiffness_matrix(link);
    const bool at_a = link.a == body;
    block_of(row, body) += at_a ? k.topLeftCorner<6, 6>() : k.bottomRightCorner<6, 6>();
    Matrix6& across = block_of(row, at_a ? link.b : link.a);
    if (at_a)
      across += k.topRightCorner<6, 6>();
    else
      across += k.topRightCorner<6, 6>().transpose();
  }
  const Vector6 own = free_ones(dofs, body);
  for (auto& [q, block] : row) {
    block = (scale.asDiagonal() * block * scale.asDiagonal()).eval();
    const Vector6 held_diagonal = block.diagonal();
    block = (own.asDiagonal() * block * free_ones(dofs, q).asDiagonal()).eval();
    if (q != body) continue;
    for (int i = 0; i < 6; ++i)
      if (own[i] == 0) block(i, i) = held_diagonal[i] > 0 ? held_diagonal[i] : 1;
  }
  std::sort(row.begin(), row.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
}

}  // namespace bondstatic
