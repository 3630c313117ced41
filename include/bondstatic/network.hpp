// The bond network: all that a solver needs to know of a model, as plain data without laws, cases or files.
#pragma once

#include <span>
#include <vector>

#include "bondstatic/bond.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic {

struct BondNetwork {
  Index bodies = 0;         ///< particles, numbered as in the model
  std::vector<Link> links;  ///< one a bond, in the model's order
  double rotation_length =
      1;  ///< rotations times this length are comparable with displacements (power of two)
};

/// One link a bond. Where a law keeps its moments in the bond (EDEM's torque feedback off), equilibrium sees
/// kt = kb = 0.
BondNetwork bond_network(const Model& model, std::span<const BondProperties> properties);

/// Which degrees of freedom are prescribed, and how the free ones are numbered: by particle, each particle's
/// free ones together and in the order x, y, z, rx, ry, rz.
struct FreeDofs {
  std::vector<std::uint8_t> free;  ///< bit i of free[p]: degree of freedom i of particle p is unknown
  std::vector<Index> first;        ///< number of a particle's first unknown; size bodies + 1

  Index unknowns() const { return first.empty() ? 0 : first.back(); }
  bool is_free(Index particle, int dof) const { return (free[std::size_t(particle)] >> dof) & 1; }
};

/// From the free masks of all particles.
FreeDofs number_free_dofs(std::vector<std::uint8_t> free);

}  // namespace bondstatic
