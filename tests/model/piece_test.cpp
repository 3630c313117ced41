#include "model/piece.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bondstatic/error.hpp"
#include "io/message.hpp"
#include "support/models.hpp"
#include "system/bisection.hpp"

namespace bondstatic::test {
namespace {

// Two blocks, one with a column; supports, loads and load cases of all kinds.
Model packing(std::mt19937_64& random) {
  Model model = random_packing(random, 4, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}}));
  model.blocks.push_back(model.blocks.front());
  std::vector<Index> count(2, 0);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    Bond& bond = model.bonds[k];
    bond.block = k % 3 == 0;
    bond.in_block = count[std::size_t(bond.block)]++;
    if (bond.block == 1) model.blocks[1].overrides[0].push_back(1e9 + double(k));
    if (bond.block == 1) model.blocks[1].fractions.push_back(1 / (1 + double(k)));
  }
  model.load_cases = {"one", "two"};
  for (Index p = 0; p < 16; ++p) fix_all(model, p);
  for (Index p = 20; p < 64; p += 3) load(model, p, vector6(1, double(p), 0), p % 2 ? 1 : every_case);
  load(model, 20, vector6(0, 0, 1));
  return model;
}

std::vector<int> ranks_of(const Model& model, int ranks) {
  std::vector<Vector3> positions;
  for (const Particle& particle : model.particles) positions.push_back(particle.position);
  return bisect(positions, ranks);
}

struct APieceOf : testing::TestWithParam<int> {
  std::mt19937_64 random{3};
  const Model whole = packing(random);
  const int ranks = GetParam();
  const std::vector<int> rank_of = ranks_of(whole, ranks);
  const Cut cut{whole, rank_of, ranks};
};

TEST_P(APieceOf, HasItsParticlesFirstAndEveryParticleOnce) {
  std::multiset<Index> found;
  for (int r = 0; r < ranks; ++r) {
    const Piece piece = cut.piece(r);
    ASSERT_EQ(piece.particle.size(), piece.model.particles.size());
    ASSERT_EQ(piece.owner.size(), piece.particle.size() - std::size_t(piece.own));
    for (std::size_t p = 0; p < piece.particle.size(); ++p) {
      const auto at = std::size_t(piece.particle[p]);
      EXPECT_EQ(piece.model.particles[p].id, whole.particles[at].id);
      EXPECT_EQ(piece.model.particles[p].position, whole.particles[at].position);
      EXPECT_EQ(rank_of[at], piece.has(Index(p)) ? r : piece.owner[p - std::size_t(piece.own)]);
      if (piece.has(Index(p))) found.insert(piece.particle[p]);
    }
    const auto middle = piece.particle.begin() + piece.own;
    EXPECT_TRUE(std::is_sorted(piece.particle.begin(), middle));
    EXPECT_TRUE(std::is_sorted(middle, piece.particle.end()));
  }
  EXPECT_EQ(found.size(), whole.particles.size());
  EXPECT_EQ(std::set<Index>(found.begin(), found.end()).size(), whole.particles.size());
}

TEST_P(APieceOf, HasTheBondsOfItsParticlesAndOwnsEachOnce) {
  std::vector<int> owners(whole.bonds.size(), 0), holders = owners;
  for (int r = 0; r < ranks; ++r) {
    const Piece piece = cut.piece(r);
    ASSERT_EQ(piece.bond.size(), piece.model.bonds.size());
    EXPECT_TRUE(std::is_sorted(piece.bond.begin(), piece.bond.end()));
    std::vector<Index> next(whole.blocks.size(), 0);
    for (std::size_t k = 0; k < piece.bond.size(); ++k) {
      const Bond &here = piece.model.bonds[k], &there = whole.bonds[std::size_t(piece.bond[k])];
      EXPECT_EQ(here.id, there.id);
      EXPECT_EQ(here.branch, there.branch);
      EXPECT_EQ(piece.particle[std::size_t(here.a)], there.a);
      EXPECT_EQ(piece.particle[std::size_t(here.b)], there.b);
      EXPECT_TRUE(piece.has(here.a) || piece.has(here.b));
      EXPECT_EQ(here.block, there.block);
      EXPECT_EQ(here.in_block, next[std::size_t(here.block)]++);
      for (const auto& [parameter, column] : whole.blocks[std::size_t(there.block)].overrides)
        EXPECT_EQ(
            piece.model.blocks[std::size_t(here.block)].overrides.at(parameter)[std::size_t(here.in_block)],
            column[std::size_t(there.in_block)]);
      if (here.block == 1) {
        EXPECT_EQ(piece.model.blocks[1].fractions.at(std::size_t(here.in_block)),
                  whole.blocks[1].fractions[std::size_t(there.in_block)]);
      }
      ++holders[std::size_t(piece.bond[k])];
      owners[std::size_t(piece.bond[k])] += piece.owns(here);
    }
  }
  for (std::size_t k = 0; k < whole.bonds.size(); ++k) {
    EXPECT_EQ(owners[k], 1);
    const Bond& bond = whole.bonds[k];
    EXPECT_EQ(holders[k], rank_of[std::size_t(bond.a)] == rank_of[std::size_t(bond.b)] ? 1 : 2);
  }
}

TEST_P(APieceOf, HasWhatActsOnItsParticlesInOrder) {
  for (int r = 0; r < ranks; ++r) {
    const Piece piece = cut.piece(r);
    EXPECT_EQ(piece.model.load_cases, whole.load_cases);
    const std::set<Index> here(piece.particle.begin(), piece.particle.end());
    std::size_t next = 0;
    for (const Load& load : whole.loads) {
      if (!here.contains(load.particle)) continue;
      ASSERT_LT(next, piece.model.loads.size());
      const Load& found = piece.model.loads[next++];
      EXPECT_EQ(piece.particle[std::size_t(found.particle)], load.particle);
      EXPECT_EQ(found.force, load.force);
      EXPECT_EQ(found.load_case, load.load_case);
    }
    EXPECT_EQ(next, piece.model.loads.size());
    Index held = 0;
    for (const Support& support : whole.supports) held += here.contains(support.particle);
    EXPECT_EQ(held, Index(piece.model.supports.size()));
    for (const Support& support : piece.model.supports)
      EXPECT_LT(piece.particle[std::size_t(support.particle)], 16);
  }
}

TEST_P(APieceOf, SurvivesAsBytes) {
  for (int r = 0; r < ranks; ++r) {
    const std::string bytes = packed(cut.piece(r));
    EXPECT_EQ(packed(unpacked<Piece>(bytes)), bytes);
    EXPECT_EQ(unpacked<Piece>(bytes).model.blocks[1].overrides, cut.piece(r).model.blocks[1].overrides);
    EXPECT_EQ(unpacked<Piece>(bytes).model.blocks[1].fractions, cut.piece(r).model.blocks[1].fractions);
  }
}

INSTANTIATE_TEST_SUITE_P(Ranks, APieceOf, testing::Values(1, 2, 3, 4, 7));

TEST(Piece, OfARankWithoutParticlesIsEmpty) {
  std::mt19937_64 random(3);
  const Model whole = packing(random);
  const Piece piece = Cut(whole, std::vector<int>(whole.particles.size(), 0), 2).piece(1);
  EXPECT_TRUE(piece.model.particles.empty());
  EXPECT_TRUE(piece.model.bonds.empty());
  EXPECT_EQ(piece.model.blocks.size(), whole.blocks.size());
}

TEST(Piece, DamagedBytesAreRefused) {
  std::mt19937_64 random(3);
  const Model whole = packing(random);
  std::string bytes = packed(Cut(whole, std::vector<int>(whole.particles.size(), 0), 1).piece(0));
  bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] + 1);
  EXPECT_THROW(unpacked<Piece>(bytes), Error);
}

}  // namespace
}  // namespace bondstatic::test
