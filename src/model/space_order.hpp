// A model renumbered so that what is near in space is near in memory. Tables list particles as it happens,
// and a sweep over the bonds of a large model in such an order waits for memory at each of them.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"
#include "io/first_touch.hpp"
#include "model/piece.hpp"

namespace bondstatic {

/// Positions in the model as it was given, in the new order.
struct SpaceOrder {
  std::vector<Index> particle, bond;
};

/// Smaller models stay in the cache whatever their order.
inline bool worth_renumbering(const Model& model) {
  return model.particles.size() >= std::size_t(1) << 14;
}

/// Particles along a Z-order curve (Morton, A computer oriented geodetic data base, IBM, 1966) through cubes
/// of which 2^21 span the model's longest extent; bonds by the first of their two particles. What is equal
/// keeps its order. Nothing but the time depends on `threads`, here and below.
SpaceOrder space_order(const Model& model, int threads = 1);

/// Ids, branches, values and directions (from a to b) stay what they are; supports and loads stay in order.
Model renumbered(const Model& model, const SpaceOrder& order, int threads = 1);

/// Where what stood at each position of old is in the new order.
std::vector<Index> positions_in(const std::vector<Index>& order);

/// Own particles along the curve, then the copies.
SpaceOrder space_order(const Piece& piece, int threads = 1);
Piece renumbered(const Piece& piece, const SpaceOrder& order, int threads = 1);

/// What belongs to particles or bonds of the new order, given in the order of old.
template <class Item>
void restore_order(std::vector<Item>& items, const std::vector<Index>& order, int threads = 1) {
  auto restored = vector_of<Item>(items.size(), threads);
  const Index count = Index(order.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index i = 0; i < count; ++i)
    restored[std::size_t(order[std::size_t(i)])] = std::move(items[std::size_t(i)]);
  items = std::move(restored);
}

}  // namespace bondstatic
