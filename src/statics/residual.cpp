#include "statics/residual.hpp"

#include <algorithm>

#include "system/link_sweeps.hpp"

namespace bondstatic {

BodyVectors<Extended> residual(const BondNetwork& network, const Boundary& boundary,
                               const BodyVectors<Extended>& motion, int threads) {
  auto r = converted<Extended>(boundary.load, threads);
  for (std::size_t p = 0; p < boundary.load_tail.size(); ++p) r[p] += boundary.load_tail[p].cast<Extended>();
  // Nearly always so at the start.
  const auto at_rest = [](const Vector6T<Extended>& u) { return u.isZero(Extended(0.0)); };
  if (boundary.strain.isZero(0) && std::all_of(motion.begin(), motion.end(), at_rest)) return r;
  subtract_carried_forces(network, motion, boundary.strain, threads, r);
  return r;
}

}  // namespace bondstatic
