// Which points and lines of a grid become rows of a scene. The choice and the order depend on the ids alone,
// so that they are the same in all states, whatever the number of ranks that wrote them.
#pragma once

#include <cstdint>
#include <vector>

#include "report/read_grid.hpp"

namespace bondstatic {

struct Sample {
  Index all_particles = 0, all_bonds = 0;
  Index drawn = 0;                  ///< the first so many rows of particles; the others are far ends of bonds
  std::vector<Index> points;        ///< of the grid: one a row of particles
  std::vector<Index> lines;         ///< one a row of bonds
  std::vector<std::uint32_t> a, b;  ///< rows of particles
};

/// Up to so many particles and bonds, in an order that looks random. A copy whose original lies in the same
/// place, of another piece, is that one.
Sample take_sample(const Grid& grid, Index particles, Index bonds);

}  // namespace bondstatic
