// Motions that cost no energy, found before the solver: isolated particles, floating bodies, bodies that
// their supports leave a rigid motion, and the hinges, rings and floppy networks that moment-free bonds
// leave.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/network.hpp"

namespace bondstatic {

/// One free motion, as the screw of the body that moves most: rotation about the line through `point` along
/// `axis`, with `pitch` displacement along it for a radian; a pure translation along `axis` where
/// `translates`.
struct FreeMotion {
  bool translates = false;
  Vector3 axis = Vector3::Zero();   ///< unit vector
  Vector3 point = Vector3::Zero();  ///< the point of the line nearest to the body's centre
  double pitch = 0;
};

struct Mechanism {
  enum class Kind { isolated, floating, underconstrained, internal };
  Kind kind = Kind::floating;
  std::vector<Index> particles;     ///< model positions of all that move, ascending
  std::vector<FreeMotion> motions;  ///< independent ones; six for isolated and floating
};

/// Bodies that nothing holds: bonded components without any prescribed degree of freedom, as lists of model
/// positions, ascending; single particles among them.
std::vector<std::vector<Index>> unsupported_bodies(const BondNetwork& network, const FreeDofs& dofs);

/// All mechanisms of the network under the given free dofs; particles in `left_out` (by position, may be
/// empty) are not looked at. Empty if the stiffness matrix of the rest is non-singular in exact arithmetic.
/// Judged by geometry and rank of C alone (unit stiffness), so no contrast of stiffness can hide or feign
/// one.
std::vector<Mechanism> find_mechanisms(const Model& model, const BondNetwork& network, const FreeDofs& dofs,
                                       const std::vector<bool>& left_out);

/// "body of particles 12, 13, 40 ... (27 in all) free to rotate about the line through (..) along (..)" and
/// cure.
std::string describe(const Model& model, const Mechanism& mechanism);

class MechanismError : public Error {
 public:
  MechanismError(const Model& model, std::vector<Mechanism> mechanisms);
  const std::vector<Mechanism>& mechanisms() const { return mechanisms_; }

 private:
  std::vector<Mechanism> mechanisms_;
};

}  // namespace bondstatic
