// r = f - B^T C (B u + strain) by body, bond by bond in natural form.
#pragma once

#include <algorithm>
#include <type_traits>

#include "model/boundary.hpp"
#include "system/link_sweeps.hpp"

namespace bondstatic {

template <class Scalar>
BodyVectors<Scalar> residual(const BondNetwork& network, const Incidence& incidence, const Boundary& boundary,
                             const BodyVectors<Scalar>& motion, int threads) {
  BodyVectors<Scalar> r = converted<Scalar>(boundary.load);
  for (std::size_t p = 0; p < boundary.load_tail.size(); ++p)
    r[p] += boundary.load_tail[p].template cast<Scalar>();
  // Nearly always so at the start.
  const auto at_rest = [](const Vector6T<Scalar>& u) { return u.isZero(Scalar(0.0)); };
  if (boundary.strain.isZero(0) && std::all_of(motion.begin(), motion.end(), at_rest)) return r;
  BodyVectors<Scalar> carried;
  if constexpr (std::is_same_v<Scalar, Extended>)
    carried = carried_forces(network, motion, boundary.strain, threads);
  else
    carried = gather_forces<Scalar>(
        network, incidence, link_resultants<Scalar>(network, motion, threads, boundary.strain), threads);
  for (std::size_t p = 0; p < r.size(); ++p) r[p] -= carried[p];
  return r;
}

}  // namespace bondstatic
