// The adjoint method's two ends: the right-hand side of a scalar's adjoint motion, and from that motion the
// scalar's derivatives to the bonds' stiffness numbers. See sensitivity.hpp.
#pragma once

#include <optional>

#include "bondstatic/network.hpp"
#include "bondstatic/sensitivity.hpp"
#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// One load case as it was solved.
struct SolvedState {
  const BodyVectors<Extended>& motion;  ///< beyond the cell's strain
  const Matrix3& strain;
  const std::vector<std::uint8_t>& free;  ///< as in FreeDofs
  const std::vector<bool>& left_out;      ///< by particle
};

/// What a functional weighs of each bond. In global axes, to the resultants q = C delta on particle a, the
/// moments that are not fed back among them.
struct LinkWeights {
  BodyVectors<double> resultants;  ///< a_k
  std::vector<double> energy;
};
LinkWeights link_weights(const Model& model, const BondNetwork& network, const Functional& functional,
                         const SolvedState& state);

/// What the adjoint motion is prescribed and loaded with.
Boundary adjoint_boundary(const BondNetwork& network, const std::vector<BondProperties>& properties,
                          const Functional& functional, const LinkWeights& weights, const SolvedState& state);

/// The factor that makes of what `state` is prescribed and loaded with what `adjoint` is, but for one
/// translation of all bodies, which no bond feels: of a displacement under its own load, and of the reaction
/// to a prescribed displacement, at either end. That multiple of the state's motion stands for the adjoint
/// motion then. Nothing where there is none.
std::optional<Extended> multiple_of(const Boundary& state, const Boundary& adjoint);
BodyVectors<Extended> times(const Extended& factor, const BodyVectors<Extended>& motion);

/// Adds the functional's part to each bond's gradient.
void add_gradient(const BondNetwork& network, const std::vector<BondProperties>& properties,
                  const Functional& functional, const LinkWeights& weights, const SolvedState& state,
                  const BodyVectors<Extended>& adjoint, int threads, BondGradients& gradient);

}  // namespace bondstatic
