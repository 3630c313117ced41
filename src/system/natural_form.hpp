// The operator K = sum B^T C B applied bond by bond, never assembled. Entries of an assembled K are rounded
// sums in which the rigid modes no longer cancel; here relative motion is formed first, so that a long-double
// evaluation knows the internal forces of slender or strongly contrasted models to far more digits than K
// has.
#pragma once

#include <vector>

#include "io/first_touch.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

/// Loops shorter than this run on one thread: waking the others would take longer.
constexpr Index worth_threads = 4000;

template <class Scalar>
using BodyVectors = std::vector<Vector6T<Scalar>>;  ///< one motion or force a body

template <class To, class From>
BodyVectors<To> converted(const BodyVectors<From>& values, int threads = 1) {
  auto result = vector_of<Vector6T<To>>(values.size(), threads);
  const Index count = Index(values.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && count > worth_threads)
  for (Index p = 0; p < count; ++p) result[std::size_t(p)] = values[std::size_t(p)].template cast<To>();
  return result;
}

/// delta of a link in a periodic cell: `motion` is what the bodies do beyond the cell's mean strain, which
/// moves the two ends apart by strain times branch.
template <class Scalar>
Vector6T<Scalar> link_motion(const Link& link, const BodyVectors<Scalar>& motion, const Matrix3& strain) {
  auto delta = relative_motion<Scalar>(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
  if (!strain.isZero(0))
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) delta[i] += Scalar(strain(i, j)) * link.branch[j];
  return delta;
}

/// q = C (B u + strain) of every link, global axes.
template <class Scalar>
BodyVectors<Scalar> link_resultants(const BondNetwork& network, const BodyVectors<Scalar>& motion,
                                    int threads, const Matrix3& strain = Matrix3::Zero()) {
  const Index count = Index(network.links.size());
  BodyVectors<Scalar> q(network.links.size());
  // Before the first correction only prescribed bodies move.
  const bool strained = !strain.isZero(0);
  const auto at_rest = [&](Index body) { return motion[std::size_t(body)].isZero(Scalar(0.0)); };
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && count > worth_threads)
  for (Index k = 0; k < count; ++k) {
    const Link& link = network.links[std::size_t(k)];
    if (!strained && at_rest(link.a) && at_rest(link.b)) {
      q[std::size_t(k)].setZero();
      continue;
    }
    q[std::size_t(k)] = resultants<Scalar>(link.stiffness, bond_axis<Scalar>(link),
                                           link_motion<Scalar>(link, motion, strain));
  }
  return q;
}

/// B^T C (B u + strain) at one body: the force that must act on it from outside.
template <class Scalar>
Vector6T<Scalar> force_on_body(const BondNetwork& network, const Incidence& incidence,
                               const BodyVectors<Scalar>& motion, Index body,
                               const Matrix3& strain = Matrix3::Zero()) {
  Vector6T<Scalar> sum = Vector6T<Scalar>::Zero();
  for (const Index k : incidence.of(body)) {
    const Link& link = network.links[std::size_t(k)];
    const auto q = resultants<Scalar>(link.stiffness, bond_axis<Scalar>(link),
                                      link_motion<Scalar>(link, motion, strain));
    sum -= link.a == body ? force_on_a<Scalar>(link, q) : force_on_b<Scalar>(link, q);
  }
  return sum;
}

/// B^T q gathered at every body: the force that must act on the body from outside.
template <class Scalar>
BodyVectors<Scalar> gather_forces(const BondNetwork& network, const Incidence& incidence,
                                  const BodyVectors<Scalar>& q, int threads) {
  BodyVectors<Scalar> force(std::size_t(network.bodies));
#pragma omp parallel for schedule(static) \
    num_threads(threads) if (threads > 1 && network.bodies > worth_threads)
  for (Index p = 0; p < network.bodies; ++p) {
    Vector6T<Scalar> sum = Vector6T<Scalar>::Zero();
    for (const Index k : incidence.of(p)) {
      if (q[std::size_t(k)].isZero(Scalar(0.0))) continue;
      const Link& link = network.links[std::size_t(k)];
      sum -= link.a == p ? force_on_a<Scalar>(link, q[std::size_t(k)])
                         : force_on_b<Scalar>(link, q[std::size_t(k)]);
    }
    force[std::size_t(p)] = sum;
  }
  return force;
}

/// Sum over the links of |B^T| |C| (|B| |u| + |strain|), taken component by component in global axes: what
/// the terms would add up to if none cancelled.
BodyVectors<double> force_magnitudes(const BondNetwork& network, const Incidence& incidence,
                                     const BodyVectors<double>& motion, int threads,
                                     const Matrix3& strain = Matrix3::Zero());

/// The same at one body.
Vector6 force_magnitude(const BondNetwork& network, const Incidence& incidence,
                        const BodyVectors<double>& motion, Index body,
                        const Matrix3& strain = Matrix3::Zero());

/// |B| |u| + |strain| of a link: relative displacement and rotation without cancellation.
Vector6 motion_magnitude(const Link& link, const Vector6& at_a, const Vector6& at_b,
                         const Matrix3& strain = Matrix3::Zero());

/// |C| |delta|, component by component in global axes, of a relative motion given by its magnitudes.
Vector6 resultant_magnitude(const SectionStiffness& stiffness, const Vector3& axis, const Vector6& motion);

}  // namespace bondstatic
