#include "system/natural_form.hpp"

namespace bondstatic {

namespace {

// |arm x v| without cancellation; both arguments are magnitudes.
Vector3 cross_magnitude(const Vector3& a, const Vector3& v) {
  return {a.y() * v.z() + a.z() * v.y(), a.z() * v.x() + a.x() * v.z(), a.x() * v.y() + a.y() * v.x()};
}

// |along e e^T + across (I - e e^T)| m
Vector3 split_magnitude(double along, double across, const Vector3& axis, const Vector3& m) {
  return (along + across) * axis.dot(m) * axis + across * m;
}

}  // namespace

Vector6 resultant_magnitude(const SectionStiffness& c, const Vector3& axis, const Vector6& motion) {
  const Vector3 e = axis.cwiseAbs(), d = motion.head<3>(), r = motion.tail<3>();
  const double coupling = std::abs(c.coupling);
  Vector6 q;
  q.head<3>() = split_magnitude(c.kn, c.ks, e, d) + coupling * cross_magnitude(e, r);
  q.tail<3>() = split_magnitude(c.kt, c.kb, e, r) + coupling * cross_magnitude(e, d);
  return q;
}

Vector6 motion_magnitude(const Link& link, const Vector6& at_a, const Vector6& at_b, const Matrix3& strain) {
  const Vector6 a = at_a.cwiseAbs(), b = at_b.cwiseAbs();
  const Vector3 lever = std::abs(link.fraction) * a.tail<3>() + std::abs(1 - link.fraction) * b.tail<3>();
  Vector6 m = a + b;
  m.head<3>() += cross_magnitude(link.branch.cwiseAbs(), lever) + strain.cwiseAbs() * link.branch.cwiseAbs();
  return m;
}

Vector6 force_magnitude(const BondNetwork& network, const Incidence& incidence,
                        const BodyVectors<double>& motion, Index body, const Matrix3& strain) {
  Vector6 sum = Vector6::Zero();
  for (const Index k : incidence.of(body)) {
    const Link& link = network.links[std::size_t(k)];
    const Vector6 m =
        motion_magnitude(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)], strain);
    const Vector6 q = resultant_magnitude(link.stiffness, bond_axis<double>(link), m);
    const double share = link.a == body ? link.fraction : 1 - link.fraction;
    sum += q;
    sum.tail<3>() += cross_magnitude((share * link.branch).cwiseAbs(), q.head<3>());
  }
  return sum;
}

BodyVectors<double> force_magnitudes(const BondNetwork& network, const Incidence& incidence,
                                     const BodyVectors<double>& motion, int threads, const Matrix3& strain) {
  BodyVectors<double> magnitude(std::size_t(network.bodies));
#pragma omp parallel for schedule(static) \
    num_threads(threads) if (threads > 1 && network.bodies > worth_threads)
  for (Index p = 0; p < network.bodies; ++p)
    magnitude[std::size_t(p)] = force_magnitude(network, incidence, motion, p, strain);
  return magnitude;
}

}  // namespace bondstatic
