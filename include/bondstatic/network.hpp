// The bond network: all that a solver needs to know of a model, as plain data without laws, cases or files.
#pragma once

#include <span>
#include <vector>

#include "bondstatic/bond.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic {

class Ranks;

/// Another rank, and the bodies that this rank and that one both know. Both lists ascend in the numbering of
/// all ranks, so that what one sends in order the other takes in order.
struct Neighbour {
  int rank = 0;
  std::vector<Index> lent;      ///< own bodies that it has copies of
  std::vector<Index> borrowed;  ///< copies of its bodies
};

/// Which part of a larger network a network is, where several ranks hold one each: all links that touch an
/// own body, and copies of the other ranks' bodies at their far ends.
struct NetworkShare {
  Ranks* ranks = nullptr;         ///< all of them; lasts as long as the share is used
  Index own = 0;                  ///< bodies 0 ... own-1 are this rank's, the others are copies
  std::vector<Vector3> position;  ///< of each body
  std::vector<Neighbour> neighbours;
};

struct BondNetwork {
  Index bodies = 0;         ///< particles, numbered as in the model
  std::vector<Link> links;  ///< one a bond, in the model's order
  double rotation_length =
      1;  ///< rotations times this length are comparable with displacements (power of two)
  const NetworkShare* share = nullptr;  ///< null: this is all of it

  /// Bodies 0 ... own()-1 are this rank's.
  Index own() const { return share ? share->own : bodies; }
  /// Of those who hold a link, one owns it.
  bool owns(const Link& link) const { return link.a < own(); }
};

/// Of a share; null where the network is all of it.
inline Ranks* ranks_of(const BondNetwork& network) {
  return network.share ? network.share->ranks : nullptr;
}

/// Of so many bonds whose branch vectors are so long together: half the mean branch is the lever arm by which
/// rotations move a contact point. A power of two scales without rounding, and hardly ever depends on the
/// order of the sum.
double rotation_length(double branches, double bonds);

/// One link a bond. Where a law keeps its moments in the bond (EDEM's torque feedback off), equilibrium sees
/// kt = kb = 0.
BondNetwork bond_network(const Model& model, std::span<const BondProperties> properties, int threads = 1);

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
