#include "statics/recover.hpp"

namespace bondstatic {

namespace {

using Extended3 = Vector3T<long double>;
using Extended6 = Vector6T<long double>;

BondResult bond_result(const Link& link, const BondProperties& properties, const Extended6& delta,
                       const Extended6& equilibrium) {
  const Extended3 axis = bond_axis<long double>(link);
  // With torque feedback off the bond still carries moments that equilibrium does not see.
  const Extended6 q =
      properties.moments_fed_back ? equilibrium : resultants<long double>(properties.stiffness, axis, delta);
  const Extended3 force = q.head<3>(), moment = q.tail<3>();
  const long double normal = axis.dot(force), twisting = axis.dot(moment);
  BondResult result;
  result.force = (-q).cast<double>();
  result.normal_force = double(normal);
  result.shear_force = double((force - normal * axis).norm());
  result.twisting_moment = double(-twisting);
  result.bending_moment = double((moment - twisting * axis).norm());
  const SectionStress stress = section_stress(q.cast<double>(), axis.cast<double>(), properties.radius);
  result.sigma = stress.sigma;
  result.tau = stress.tau;
  result.energy = double(0.5L * delta.dot(equilibrium));
  return result;
}

BondResult no_result() {
  return {Vector6::Constant(not_given),
          not_given,
          not_given,
          not_given,
          not_given,
          not_given,
          not_given,
          not_given};
}

double ratio(long double part, long double whole) {
  return whole > 0 ? double(part / whole) : 0.0;
}

void balance(const Model& model, const std::vector<bool>& left_out, const BodyVectors<long double>& outside,
             Accuracy& accuracy) {
  Extended3 centre = Extended3::Zero(), force = Extended3::Zero(), moment = Extended3::Zero();
  for (const Particle& particle : model.particles) centre += particle.position.cast<long double>();
  centre /= static_cast<long double>(std::max<std::size_t>(1, model.particles.size()));
  long double forces = 0, moments = 0;
  for (std::size_t p = 0; p < outside.size(); ++p) {
    if (left_out[p]) continue;
    const Extended3 f = outside[p].head<3>(), m = outside[p].tail<3>();
    const Extended3 arm = model.particles[p].position.cast<long double>() - centre;
    force += f;
    moment += arm.cross(f) + m;
    forces += f.norm();
    moments += arm.norm() * f.norm() + m.norm();
  }
  accuracy.force_balance = ratio(force.norm(), forces);
  accuracy.moment_balance = ratio(moment.norm(), moments);
}

}  // namespace

LoadCaseResult recover(const Model& model, const BondNetwork& network, const Incidence& incidence,
                       const std::vector<BondProperties>& properties, const Boundary& boundary,
                       const std::vector<bool>& left_out, const Refined& refined, int threads) {
  const std::size_t particles = model.particles.size(), bonds = network.links.size();
  const auto& motion = refined.motion;
  LoadCaseResult result;
  result.accuracy = refined.accuracy;
  result.displacement.resize(particles);
  result.reaction.resize(particles);
  result.bonds.resize(bonds);

  const auto q = link_resultants<long double>(network, motion, threads);
  auto outside = gather_forces<long double>(network, incidence, q, threads);
  long double energy = 0, work = 0;
  for (std::size_t k = 0; k < bonds; ++k) {
    const Link& link = network.links[k];
    if (left_out[std::size_t(link.a)]) {
      result.bonds[k] = no_result();
      continue;
    }
    const auto delta =
        relative_motion<long double>(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
    energy += 0.5L * delta.dot(q[k]);
    result.bonds[k] = bond_result(link, properties[k], delta, q[k]);
  }
  for (std::size_t p = 0; p < particles; ++p) {
    if (left_out[p]) {
      result.displacement[p] = result.reaction[p] = Vector6::Constant(not_given);
      continue;
    }
    result.displacement[p] = motion[p].cast<double>();
    for (int i = 0; i < 6; ++i) {
      const bool free = (boundary.free[p] >> i) & 1;
      const long double load = boundary.load[p][i];
      result.reaction[p][i] = free ? 0.0 : double(outside[p][i] - load);
      // Where nothing is prescribed the outside force is the load; B^T q equals it only to the residual.
      if (free) outside[p][i] = load;
      work += outside[p][i] * motion[p][i];
    }
  }
  result.energy = double(energy);
  result.work = double(work);
  result.accuracy.energy_balance = ratio(std::abs(2 * energy - work), 2 * energy);
  balance(model, left_out, outside, result.accuracy);
  return result;
}

}  // namespace bondstatic
