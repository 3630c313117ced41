// Which particles are bonded when bonds form: once, by distance.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bondstatic/model.hpp"
#include "model/cell.hpp"

namespace bondstatic {

/// A bond forms where |x_b - x_a| <= factor (Ra + Rb) + gap, within 1e-9 (Ra + Rb): factor 1 with PFC's
/// reference gap, or gap 0 with EDEM's and YADE's contact radius factor.
struct Formation {
  double gap = 0;
  double contact_radius_factor = 1;
};

/// Pairs of model positions, ids ascending within a pair and sorted by (id of a, id of b). Where `between` is
/// given, one end lies in its first and the other in its second list (ascending positions; the lists may
/// overlap or be equal). Nothing but the time depends on `threads`.
using PositionLists = std::pair<std::vector<Index>, std::vector<Index>>;
std::vector<std::pair<Index, Index>> bonded_pairs(std::span<const Particle> particles,
                                                  const Formation& formation,
                                                  const PositionLists* between = nullptr, int threads = 1);

/// The longest bond that could form among the particles of the lists; 0 where there are none.
double longest_bond(std::span<const Particle> particles, const Formation& formation,
                    const PositionLists* between = nullptr);

/// The pairs in a periodic cell, where the bond goes from a to the image of b (in model positions, not in
/// those brought into the cell). A particle near its own image is paired with itself. Time and memory grow
/// with the cube of longest_bond() over the cell's height: callers refuse the absurd.
struct BondedImage {
  Index a = 0;
  Index b = 0;
  CellImage image{};
};
std::vector<BondedImage> bonded_images(std::span<const Particle> particles, const Cell& cell,
                                       const Formation& formation, const PositionLists* between = nullptr,
                                       int threads = 1);

}  // namespace bondstatic
