#include "system/block_row.hpp"

#include <gtest/gtest.h>

#include "bondstatic/bond_law.hpp"
#include "support/models.hpp"
#include "system/assemble.hpp"
#include "system/body_positions.hpp"

namespace bondstatic::test {
namespace {

struct Packing {
  Model model;
  BondNetwork network;
  Incidence incidence;

  Packing() {
    std::mt19937_64 random(11);
    model = random_packing(random, 3, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
    network = bond_network(model, bond_properties(model));
    incidence = link_incidence(network);
  }
};

FreeDofs free_but(const BondNetwork& network, Index body, std::uint8_t free) {
  std::vector<std::uint8_t> masks(std::size_t(network.bodies), 0x3f);
  masks[std::size_t(body)] = free;
  return number_free_dofs(std::move(masks));
}

TEST(BlockRow, IsTheAssembledMatrixWithHeldUnknownsOnTheDiagonal) {
  const Packing packing;
  const BondNetwork& network = packing.network;
  const FreeDofs dofs = free_but(network, 4, 0b010110);
  const BodyGraph graph = body_graph(network, packing.incidence);
  SparseMatrix lower = stiffness_pattern(graph, dofs);
  assemble(network, packing.incidence, graph, dofs, 1, lower);
  const Eigen::MatrixXd k = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const double largest = k.lpNorm<Eigen::Infinity>();
  BlockRow row;
  for (Index p = 0; p < network.bodies; ++p) {
    block_row(network, packing.incidence, dofs, p, row);
    for (const auto& [q, entries] : row)
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const auto unknown = [&](Index body, int dof) {
            Index n = dofs.first[std::size_t(body)];
            for (int d = 0; d < dof; ++d) n += dofs.is_free(body, d);
            return n;
          };
          if (dofs.is_free(p, i) && dofs.is_free(q, j))
            EXPECT_NEAR(entries(i, j), k(unknown(p, i), unknown(q, j)), 1e-15 * largest);
          else if (p == q && i == j)
            EXPECT_GT(entries(i, j), 0);
          else
            EXPECT_EQ(entries(i, j), 0);
        }
  }
}

TEST(BlockRow, BlocksAcrossTheDiagonalAreTransposed) {
  const Packing packing;
  const FreeDofs dofs = free_but(packing.network, 4, 0b010110);
  std::vector<BlockRow> rows(std::size_t(packing.network.bodies));
  for (Index p = 0; p < packing.network.bodies; ++p)
    block_row(packing.network, packing.incidence, dofs, p, rows[std::size_t(p)]);
  for (Index p = 0; p < packing.network.bodies; ++p)
    for (const auto& [q, entries] : rows[std::size_t(p)]) {
      const BlockRow& other = rows[std::size_t(q)];
      const auto mirrored =
          std::find_if(other.begin(), other.end(), [&](const auto& b) { return b.first == p; });
      ASSERT_NE(mirrored, other.end());
      if (p == q) continue;
      EXPECT_EQ(mirrored->second.transpose(), entries);
    }
}

TEST(BodyPositions, AreTheModelsUpToATranslationOfEachPart) {
  Packing packing;
  const Index lonely = add_particle(packing.model, {50, 0, 0}, 0.4);
  packing.network.bodies = lonely + 1;
  const auto found = body_positions(packing.network, link_incidence(packing.network));
  Vector3 centre = Vector3::Zero();
  for (Index p = 0; p < lonely; ++p)
    centre += packing.model.particles[std::size_t(p)].position / double(lonely);
  for (Index p = 0; p < lonely; ++p)
    EXPECT_LT((found[std::size_t(p)] + centre - packing.model.particles[std::size_t(p)].position).norm(),
              1e-14);
  EXPECT_EQ(found[std::size_t(lonely)], Vector3::Zero());
}

}  // namespace
}  // namespace bondstatic::test
