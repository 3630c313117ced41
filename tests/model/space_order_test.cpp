#include "model/space_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/models.hpp"
#include "support/shuffled.hpp"

namespace bondstatic::test {
namespace {

Model packing(int edge) {
  std::mt19937_64 random(3);
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}}));
  for (Index p = 0; p < edge; ++p) fix_all(model, p);
  for (Index p = 2 * edge; p < 3 * edge; ++p) load(model, p, vector6(1, double(p), 0));
  return shuffled(model, random);
}

// In memory, of bonds between two of the first `own` particles.
double mean_distance(const Model& model, Index own) {
  double sum = 0, bonds = 0;
  for (const Bond& bond : model.bonds)
    if (bond.a < own && bond.b < own) sum += double(std::abs(bond.a - bond.b)), ++bonds;
  return sum / bonds;
}

double mean_distance(const Model& model) {
  return mean_distance(model, Index(model.particles.size()));
}

TEST(SpaceOrder, IsTheCurveInACubeOfEight) {
  Model model;
  for (const Vector3& corner :
       {Vector3(1, 1, 1), Vector3(0, 0, 1), Vector3(0, 1, 0), Vector3(1, 0, 0), Vector3(0, 0, 0),
        Vector3(1, 1, 0), Vector3(0, 1, 1), Vector3(1, 0, 1), Vector3(0, 0, 0)})
    add_particle(model, Vector3(-3, 5, 7) + 1e-3 * corner, 1e-4);
  EXPECT_EQ(space_order(model).particle, (std::vector<Index>{4, 8, 3, 2, 5, 1, 7, 6, 0}));
}

TEST(SpaceOrder, BringsNeighboursTogether) {
  const Model model = packing(16);
  const Model near = renumbered(model, space_order(model));
  EXPECT_NEAR(mean_distance(model), 4096 / 3.0, 50);
  EXPECT_LT(mean_distance(near), 200);
  const auto first = [](const Bond& bond) { return std::min(bond.a, bond.b); };
  EXPECT_TRUE(std::is_sorted(near.bonds.begin(), near.bonds.end(),
                             [&](const Bond& l, const Bond& r) { return first(l) < first(r); }));
}

TEST(SpaceOrder, KeepsTheModelButItsNumbers) {
  const Model model = packing(7);
  for (const int threads : {1, 3}) {
    const SpaceOrder order = space_order(model, threads);
    const Model near = renumbered(model, order, threads);
    ASSERT_EQ(near.particles.size(), model.particles.size());
    ASSERT_EQ(near.bonds.size(), model.bonds.size());
    for (std::size_t p = 0; p < near.particles.size(); ++p) {
      const Particle& given = model.particles[std::size_t(order.particle[p])];
      EXPECT_EQ(near.particles[p].id, given.id);
      EXPECT_EQ(near.particles[p].position, given.position);
      EXPECT_EQ(near.particles[p].radius, given.radius);
    }
    const auto id = [](const Model& of, Index p) { return of.particles[std::size_t(p)].id; };
    for (std::size_t k = 0; k < near.bonds.size(); ++k) {
      const Bond &bond = near.bonds[k], &given = model.bonds[std::size_t(order.bond[k])];
      EXPECT_EQ(bond.id, given.id);
      EXPECT_EQ(id(near, bond.a), id(model, given.a));
      EXPECT_EQ(id(near, bond.b), id(model, given.b));
      EXPECT_EQ(bond.branch, given.branch);
      EXPECT_EQ(bond.block, given.block);
      EXPECT_EQ(bond.in_block, given.in_block);
    }
    for (std::size_t i = 0; i < near.supports.size(); ++i)
      EXPECT_EQ(id(near, near.supports[i].particle), id(model, model.supports[i].particle));
    for (std::size_t i = 0; i < near.loads.size(); ++i)
      EXPECT_EQ(id(near, near.loads[i].particle), id(model, model.loads[i].particle));
  }
}

TEST(SpaceOrder, OfAPieceKeepsOwnParticlesFirst) {
  const Model model = packing(12);
  std::vector<int> rank_of;
  for (const Particle& p : model.particles) rank_of.push_back(int(p.position.x()) / 4);
  const Cut cut(model, rank_of, 3);
  for (int rank = 0; rank < 3; ++rank) {
    const Piece piece = cut.piece(rank);
    const SpaceOrder order = space_order(piece, 2);
    const Piece near = renumbered(piece, order, 2);
    EXPECT_LT(mean_distance(near.model, piece.own), 0.5 * mean_distance(piece.model, piece.own));
    ASSERT_EQ(near.own, piece.own);
    ASSERT_EQ(near.owner.size(), piece.owner.size());
    for (std::size_t p = 0; p < near.particle.size(); ++p) {
      EXPECT_EQ(near.model.particles[p].id, model.particles[std::size_t(near.particle[p])].id);
      EXPECT_EQ(near.particle[p], piece.particle[std::size_t(order.particle[p])]);
      EXPECT_EQ(rank_of[std::size_t(near.particle[p])],
                near.has(Index(p)) ? rank : near.owner[p - std::size_t(near.own)]);
    }
    Index owned = 0, owned_before = 0;
    for (const Bond& bond : piece.model.bonds) owned_before += piece.owns(bond);
    for (std::size_t k = 0; k < near.bond.size(); ++k) {
      const Bond &here = near.model.bonds[k], &there = model.bonds[std::size_t(near.bond[k])];
      EXPECT_EQ(here.id, there.id);
      EXPECT_EQ(near.particle[std::size_t(here.a)], there.a);
      EXPECT_EQ(near.particle[std::size_t(here.b)], there.b);
      owned += near.owns(here);
    }
    EXPECT_EQ(owned, owned_before);
  }
}

TEST(SpaceOrder, GivesBackWhatBelongsToTheGivenModel) {
  const Model model = packing(7);
  const SpaceOrder order = space_order(model);
  std::vector<Index> ids;
  for (const Bond& bond : renumbered(model, order).bonds) ids.push_back(bond.id);
  restore_order(ids, order.bond, 2);
  for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(ids[k], model.bonds[k].id);
}

TEST(SpaceOrder, TakesWhatHasNoExtent) {
  EXPECT_TRUE(space_order(Model{}).particle.empty());
  EXPECT_TRUE(space_order(Piece{}).particle.empty());
  Model model;
  for (int i = 0; i < 3; ++i) add_particle(model, Vector3(1, 2, 3), 1);
  EXPECT_EQ(space_order(model).particle, (std::vector<Index>{0, 1, 2}));
}

}  // namespace
}  // namespace bondstatic::test
