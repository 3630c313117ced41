// What holds the model: free degrees of freedom of a load case, bodies that nothing holds, motions that cost
// no energy.
#pragma once

#include "bondstatic/network.hpp"
#include "bondstatic/statics.hpp"
#include "model/boundary.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct Held {
  FreeDofs dofs;
  std::vector<bool> left_out;               ///< by particle
  std::vector<std::vector<Index>> dropped;  ///< bodies left out, ids of their particles
};

/// `free` as in FreeDofs. Bodies that nothing holds are left out as a whole where `unsupported` says so.
/// Throws MechanismError, naming particles and motions, where what is left can move without energy, and where
/// nothing is left.
Held held_by(const Model& model, const BondNetwork& network, std::vector<std::uint8_t> free,
             Unsupported unsupported);

/// What loads of a load case are lost with particles left out, as a warning; "" where none are. On several
/// ranks the same on all.
std::string lost_loads(const BondNetwork& network, const Held& held, const Boundary& boundary,
                       const std::string& load_case, Ranks* ranks = nullptr);

}  // namespace bondstatic
