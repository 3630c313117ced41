#include "statics/recover.hpp"

namespace bondstatic {

namespace {

using Extended3 = Vector3T<Extended>;
using Extended6 = Vector6T<Extended>;

// A value beside the sum of the magnitudes it was formed from.
double settled(const Extended& value, double magnitude) {
  const double rounded = to_double(value);
  return std::abs(rounded) <= negligible * magnitude ? 0.0 : rounded;
}

// What a bond carries, and how large it would be without cancellation.
struct Carried {
  Extended6 q;
  double force = 0;
  double moment = 0;
};

BondResult bond_result(const Carried& carried, const Extended3& axis, double radius) {
  const Extended3 force = carried.q.head<3>(), moment = carried.q.tail<3>();
  const Extended normal = axis.dot(force), twisting = axis.dot(moment);
  BondResult result;
  for (int i = 0; i < 6; ++i)
    result.force[i] = settled(-carried.q[i], i < 3 ? carried.force : carried.moment);
  result.normal_force = settled(normal, carried.force);
  result.shear_force = settled((force - normal * axis).norm(), carried.force);
  result.twisting_moment = settled(-twisting, carried.moment);
  result.bending_moment = settled((moment - twisting * axis).norm(), carried.moment);
  const SectionStress stress = section_stress(
      {result.normal_force, result.shear_force, result.twisting_moment, result.bending_moment}, radius);
  result.sigma = stress.sigma;
  result.tau = stress.tau;
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

double ratio(const Extended& part, const Extended& whole) {
  return whole > 0.0 ? to_double(part / whole) : 0.0;
}

void balance(const Model& model, const std::vector<bool>& left_out, const BodyVectors<Extended>& outside,
             Accuracy& accuracy) {
  Vector3 centre = Vector3::Zero();
  for (const Particle& particle : model.particles) centre += particle.position;
  centre /= double(std::max<std::size_t>(1, model.particles.size()));
  Extended3 force = Extended3::Zero(), moment = Extended3::Zero();
  Extended forces = 0.0, moments = 0.0;
  for (std::size_t p = 0; p < outside.size(); ++p) {
    if (left_out[p]) continue;
    const Extended3 f = outside[p].head<3>(), m = outside[p].tail<3>();
    const Extended3 arm = model.particles[p].position.cast<Extended>() - centre.cast<Extended>();
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
  const std::size_t particles = model.particles.size();
  const Index bonds = Index(network.links.size());
  const auto& motion = refined.motion;
  LoadCaseResult result;
  result.accuracy = refined.accuracy;
  result.displacement.resize(particles);
  result.reaction.resize(particles);
  result.bonds.resize(std::size_t(bonds));
  for (std::size_t p = 0; p < particles; ++p)
    result.displacement[p] =
        left_out[p] ? Vector6(Vector6::Constant(not_given)) : Vector6(motion[p].cast<double>());

  const auto q = link_resultants<Extended>(network, motion, threads);
  std::vector<Extended> energies(std::size_t(bonds), 0.0);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bonds > worth_threads)
  for (Index k = 0; k < bonds; ++k) {
    const Link& link = network.links[std::size_t(k)];
    const auto a = std::size_t(link.a), b = std::size_t(link.b);
    if (left_out[a]) {
      result.bonds[std::size_t(k)] = no_result();
      continue;
    }
    // With torque feedback off the bond still carries moments that equilibrium does not see.
    const BondProperties& bond = properties[std::size_t(k)];
    const Extended3 axis = bond_axis<Extended>(link);
    const Extended6 delta = relative_motion<Extended>(link, motion[a], motion[b]);
    const Vector6 moved = motion_magnitude(link, result.displacement[a], result.displacement[b]);
    const Vector6 magnitude = resultant_magnitude(bond.stiffness, axis.cast<double>(), moved);
    const Carried carried{
        bond.moments_fed_back ? q[std::size_t(k)] : resultants<Extended>(bond.stiffness, axis, delta),
        magnitude.head<3>().norm(), magnitude.tail<3>().norm()};
    BondResult& found = result.bonds[std::size_t(k)];
    found = bond_result(carried, axis, bond.radius);
    energies[std::size_t(k)] = 0.5 * delta.dot(q[std::size_t(k)]);
    // Quadratic in the motion, so that its rounding is that of the motion squared.
    found.energy = settled(energies[std::size_t(k)], negligible * magnitude.dot(moved));
  }
  Extended energy = 0.0, work = 0.0;
  for (const Extended& part : energies) energy += part;

  auto outside = gather_forces<Extended>(network, incidence, q, threads);
  const auto magnitude = force_magnitudes(network, incidence, converted<double>(motion), threads);
  for (std::size_t p = 0; p < particles; ++p) {
    if (left_out[p]) {
      result.reaction[p] = Vector6::Constant(not_given);
      continue;
    }
    for (int i = 0; i < 6; ++i) {
      const bool free = (boundary.free[p] >> i) & 1;
      const double load = boundary.load[p][i];
      result.reaction[p][i] = free ? 0.0 : settled(outside[p][i] - load, magnitude[p][i] + std::abs(load));
      // Where nothing is prescribed the outside force is the load; B^T q equals it only to the residual.
      if (free) outside[p][i] = load;
      work += outside[p][i] * motion[p][i];
    }
  }
  result.energy = to_double(energy);
  result.work = to_double(work);
  result.accuracy.energy_balance = ratio(abs(2.0 * energy - work), 2.0 * energy);
  balance(model, left_out, outside, result.accuracy);
  return result;
}

}  // namespace bondstatic
