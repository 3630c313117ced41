// Models whose tables list everything as it happens.
#pragma once

#include <algorithm>
#include <numeric>
#include <random>

#include "model/space_order.hpp"

namespace bondstatic::test {

inline Model shuffled(const Model& model, std::mt19937_64& random) {
  SpaceOrder order{std::vector<Index>(model.particles.size()), std::vector<Index>(model.bonds.size())};
  for (std::vector<Index>* items : {&order.particle, &order.bond}) {
    std::iota(items->begin(), items->end(), Index(0));
    std::shuffle(items->begin(), items->end(), random);
  }
  return renumbered(model, order);
}

}  // namespace bondstatic::test
