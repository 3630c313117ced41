// Packings to compare solvers on, of any number of particles: held by their lowest layer, their highest one
// pushed down and aside.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic::bench {

/// Simple cubic lattice of touching spheres, 3 bonds a particle.
Model cubic_packing(Index nx, Index ny, Index nz);

/// FCC lattice of `cells`^3 cells, 4 particles each, every particle moved by up to a tenth of the pitch, 27
/// of 100 bonds removed at random: 4.4 bonds a particle. A few at the surface may hang by no bond.
Model disordered_fcc(Index cells);

/// About so many of the spheres of cases/yade-packing, which is reflected inside its walls again and again
/// and cut to a cube; every sphere moved by up to a hundredth of its radius. Spheres cut loose hang by no
/// bond.
Model yade_like(Index particles);

/// Gives every bond a Young's modulus of its own, log-uniform over so many decades above the block's.
void vary_stiffness(Model& model, double decades);

/// A family of packings that differ in size.
struct Family {
  std::string name;
  Model (*make)(Index particles);
  bool grows;  ///< false: one size only, whatever it is asked for
};
const std::vector<Family>& families();

}  // namespace bondstatic::bench
