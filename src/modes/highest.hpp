// The largest eigenvalue of M^-1 K without any matrix.
#pragma once

#include "modes/eigenpairs.hpp"
#include "modes/masses.hpp"

namespace bondstatic {

/// Of M^-1/2 K M^-1/2 in mass-weighted unknowns, of which there must be one at least; `roots` from
/// mass_roots(), `tolerance` on the residual over the eigenvalue.
DominantPair highest_pair(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                          const Eigen::VectorXd& roots, int threads, double tolerance = 1e-10);

}  // namespace bondstatic
